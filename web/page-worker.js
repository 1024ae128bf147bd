// The worker of the page, which fetches its wasm.
import init from 'nctape';
import { serve } from './worker.js';

serve(init());
