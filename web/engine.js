// The page's side of the worker: numbers requests, throws late replies away, restarts after a trap.
//
// One change is under way at a time. What changes meanwhile is put together and sent as one,
// so that a long tape is never more than one change behind the typing.

import { timed } from './timing.js';

/** @typedef {import('./worker.js').Changes} Changes */
/** @typedef {import('./worker.js').Facts} Facts */
/** @typedef {import('./worker.js').Questions} Questions */
/** @typedef {import('./worker.js').Change} Change */
/** @typedef {[name: keyof Questions, ...args: (string | number)[]]} Foreseen  a question and its arguments */
/** @typedef {{ source: string, format: import('nctape').Format, kind?: import('nctape').SourceKind, skip: boolean, offset: number }} Current  kind: left out, it is a tape */

/**
 * @template {any[]} T
 * @typedef {T extends [any, ...infer R] ? R : never} Tail
 */

/**
 * What was changed and is not sent yet.
 * @typedef {object} Waiting
 * @property {import('@codemirror/state').ChangeSet | null} changes
 * @property {import('nctape').Format | null} format
 * @property {boolean | null} skip
 * @property {number} offset
 */

/**
 * @typedef {object} Callbacks
 * @property {() => Worker} makeWorker  a new one: at the start, and after a trap
 * @property {() => Current} current  what the tape is now, for a new worker
 * @property {(change: Change) => void} onChange  the newest change was read
 * @property {(refusal: string) => void} onRefusal  an argument was malformed: the tape stays as it was
 * @property {(message: string, down: boolean) => void} onTrap  the worker died; `down`: it waits for the next change
 * @property {(message: string) => void} onFail  the wasm could not be loaded
 */

/**
 * @typedef {object} Pending
 * @property {{ id: number, about: 'change' | 'tape' | 'fact', name: string, args: any[] }} request
 * @property {number} edit  the number of changes made before it, its own included
 * @property {(value: any) => void} resolve
 */

export class Engine {
  /** @param {Callbacks} callbacks */
  constructor(callbacks) {
    this.callbacks = callbacks;
    /** @type {Map<number, Pending>} */
    this.pending = new Map();
    /** What goes to the worker in one message: the views ask in the same moment, and are answered in the same one. */
    this.outbox = /** @type {Pending['request'][]} */ ([]);
    /** What the views will ask of a changed tape. @type {(() => Foreseen[])[]} */
    this.seers = [];
    /** The answers that come with the newest change, by question. @type {Map<string, Promise<any>>} */
    this.foreseen = new Map();
    this.lastId = 0;
    /** How many changes have been made. */
    this.edit = 0;
    /** A change is sent and not answered. */
    this.busy = false;
    /** @type {Waiting | null} */
    this.waiting = null;
    /** Deaths of the worker since the last change by the user. */
    this.traps = 0;
    /** This very tape makes the worker die: nothing is sent before it changes. */
    this.down = false;
    this.opened = false;
    this.worker = this.start();
  }

  start() {
    const worker = this.callbacks.makeWorker();
    let alive = false;
    worker.onmessage = ({ data }) => {
      if (data.ready) alive = true;
      else if (data.failed !== undefined) this.callbacks.onFail(data.failed);
      else for (const reply of data.replies) this.settle(reply);
      if (data.trap !== undefined) this.restart(data.trap);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (alive) this.restart(event.message);
      else this.callbacks.onFail(event.message || 'the worker’s file could not be loaded');
    };
    return worker;
  }

  /**
   * A question that needs no tape: always answered.
   * @template {keyof Facts} K
   * @param {K} name
   * @param {Parameters<Facts[K]>} args
   * @returns {Promise<Awaited<ReturnType<Facts[K]>>>}
   */
  fact(name, ...args) {
    return this.send('fact', name, args);
  }

  /**
   * A question about the tape as it is now; undefined if the tape changes before the answer is here.
   * @template {keyof Questions} K
   * @param {K} name
   * @param {Tail<Parameters<Questions[K]>>} args
   * @returns {Promise<ReturnType<Questions[K]> | undefined>}
   */
  ask(name, ...args) {
    if (this.down || !this.opened || this.waiting !== null) return Promise.resolve(undefined);
    const question = JSON.stringify([name, ...args]);
    const answer = this.foreseen.get(question);
    this.foreseen.delete(question);
    return answer ?? this.send('tape', name, args);
  }

  /**
   * What a view will ask of the changed tape is asked with the change: the answers come with it, and all views show them
   * in one frame. A question that was not foreseen takes its own way.
   * @param {() => Foreseen[]} seer
   */
  foresee(seer) {
    this.seers.push(seer);
  }

  /** Sends the tape as it is now, in place of all that was sent before. */
  open() {
    this.opened = true;
    this.down = false;
    this.waiting = null;
    this.edit += 1;
    const { source, format, kind = 'tape', skip, offset } = this.callbacks.current();
    this.sendChange('open', source, format, kind, skip, offset);
  }

  /** The text is something else from now on: a tape, or CLDATA. */
  reopen() {
    this.traps = 0;
    this.open();
  }

  /**
   * Changes the tape. The answer to the newest change goes to `onChange`.
   * @param {Partial<Waiting> & { offset: number }} change
   */
  alter({ changes = null, format = null, skip = null, offset }) {
    this.traps = 0;
    if (this.down || !this.opened) {
      this.open();
      return;
    }
    this.edit += 1;
    const before = this.waiting?.changes ?? null;
    this.waiting = {
      changes: before === null || changes === null ? (changes ?? before) : before.compose(changes),
      format: format ?? this.waiting?.format ?? null,
      skip: skip ?? this.waiting?.skip ?? null,
      offset,
    };
    if (!this.busy) this.sendWaiting();
  }

  /** @private */
  sendWaiting() {
    if (this.waiting === null) return;
    const { changes, format, skip, offset } = this.waiting;
    this.waiting = null;
    /** @type {[number, number, string][]} */
    const edits = [];
    changes?.iterChanges((from, to, _from, _to, insert) => edits.push([from, to, insert.toString()]));
    this.sendChange('alter', edits.reverse(), format, skip, offset);
  }

  /**
   * @private
   * @template {keyof Changes} K
   * @param {K} name
   * @param {Parameters<Changes[K]>} args
   */
  async sendChange(name, ...args) {
    this.busy = true;
    const { worker } = this;
    const answer = this.send('change', name, args);
    this.foreseen.clear();
    for (const [question, ...asked] of this.seers.flatMap((seer) => seer())) {
      this.foreseen.set(JSON.stringify([question, ...asked]), this.send('tape', question, asked));
    }
    /** @type {Change | undefined} */
    const change = await answer;
    if (worker !== this.worker) return;
    this.busy = false;
    if (this.waiting !== null) this.sendWaiting();
    else if (change !== undefined) timed('nctape.show', () => this.callbacks.onChange(change));
  }

  /**
   * @private
   * @param {'change' | 'tape' | 'fact'} about
   * @param {string} name
   * @param {any[]} args
   * @returns {Promise<any>}
   */
  send(about, name, args) {
    this.lastId += 1;
    const request = { id: this.lastId, about, name, args };
    return new Promise((resolve) => {
      this.pending.set(request.id, { request, edit: this.edit, resolve });
      this.post(request);
    });
  }

  /**
   * @private
   * @param {Pending['request']} request
   */
  post(request) {
    this.outbox.push(request);
    if (this.outbox.length === 1) queueMicrotask(() => this.worker.postMessage(this.outbox.splice(0)));
  }

  /**
   * @private
   * @param {{ id: number, value?: any, refused?: string }} reply
   */
  settle(reply) {
    const waiting = this.pending.get(reply.id);
    if (waiting === undefined) return;
    this.pending.delete(reply.id);
    if (reply.refused !== undefined) this.callbacks.onRefusal(reply.refused);
    const { about } = waiting.request;
    const late = about !== 'fact' && waiting.edit < this.edit;
    waiting.resolve(late ? undefined : reply.value);
  }

  /**
   * A new worker with the current text. Where that text has killed two workers, it waits for the next change.
   * @private
   * @param {string} message
   */
  restart(message) {
    this.traps += 1;
    this.down = this.traps > 1;
    this.worker.terminate();
    this.outbox.length = 0;
    this.foreseen.clear();
    const unanswered = [...this.pending.values()];
    this.pending.clear();
    this.worker = this.start();
    for (const waiting of unanswered) {
      if (waiting.request.about !== 'fact') waiting.resolve(undefined);
      else if (!this.down) {
        this.pending.set(waiting.request.id, waiting);
        this.post(waiting.request);
      }
    }
    this.callbacks.onTrap(message, this.down);
    this.busy = false;
    this.waiting = null;
    if (!this.down) this.open();
  }
}
