//! A web server for a folder of files on this machine, and no more than that.

mod mime;
mod request;
mod server;

pub use server::{listen, serve};
