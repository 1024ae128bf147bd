//! The connections.

use std::fs;
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::mime::media_type;
use super::request::{Refusal, Request};
use crate::Trouble;

/// Longer than any request of a browser to this machine, so a silent connection ends.
const PATIENCE: Duration = Duration::from_secs(10);

/// A request line and headers; browsers send a kilobyte or two.
const LONGEST_REQUEST: u64 = 64 * 1024;

/// Listens on this machine only: at the port asked for, or else at the usual one or, where that is
/// taken, at any free one.
pub fn listen(asked: Option<u16>, usual: u16) -> Result<TcpListener, Trouble> {
    let at = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
    let port = asked.unwrap_or(usual);
    match at(port) {
        Err(e) if e.kind() == ErrorKind::AddrInUse && asked.is_none() => at(0),
        other => other,
    }
    .map_err(|e| format!("port {port} cannot be listened at: {e}. Choose another by --port."))
}

/// Answers requests with the files of a folder until the process is ended.
pub fn serve(listener: &TcpListener, folder: &Path) -> Result<(), Trouble> {
    let folder = fs::canonicalize(folder).map_err(|e| format!("{} cannot be served: {e}.", folder.display()))?;
    for stream in listener.incoming() {
        let folder = folder.clone();
        // A connection that breaks off concerns nobody but the browser that broke it off.
        thread::spawn(move || stream.and_then(|stream| answer(stream, &folder)));
    }
    Ok(())
}

fn answer(mut stream: TcpStream, folder: &Path) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let line = read_request(&stream)?;
    match Request::from_line(&line) {
        Ok(request) => match find(folder, &request.file) {
            Some(file) => send_file(&mut stream, &file, request.head_only),
            None => send_refusal(&mut stream, "404 Not Found"),
        },
        Err(Refusal::Bad) => send_refusal(&mut stream, "400 Bad Request"),
        Err(Refusal::Method) => send_refusal(&mut stream, "405 Method Not Allowed"),
    }
}

/// The request line. The headers are read too: to close with them unread would reset the connection
/// before the answer arrives.
fn read_request(stream: &TcpStream) -> io::Result<String> {
    let mut reader = BufReader::new(stream.take(LONGEST_REQUEST));
    let mut first = String::new();
    reader.read_line(&mut first)?;
    let mut header = Vec::new();
    while reader.read_until(b'\n', &mut header)? > 2 {
        header.clear();
    }
    Ok(first)
}

fn find(folder: &Path, relative: &Path) -> Option<PathBuf> {
    // Resolved, so that a symbolic link does not lead out of the folder either.
    let file = fs::canonicalize(folder.join(relative)).ok()?;
    (file.starts_with(folder) && file.is_file()).then_some(file)
}

fn send_file(stream: &mut TcpStream, file: &Path, head_only: bool) -> io::Result<()> {
    let body = fs::read(file)?;
    write!(
        stream,
        "HTTP/1.1 200 OK\r\n\
         Content-Type: {}\r\n\
         Content-Length: {}\r\n\
         Cache-Control: no-cache\r\n\
         X-Content-Type-Options: nosniff\r\n\
         Connection: close\r\n\r\n",
        media_type(file),
        body.len()
    )?;
    if !head_only {
        stream.write_all(&body)?;
    }
    stream.flush()
}

fn send_refusal(stream: &mut TcpStream, status: &str) -> io::Result<()> {
    write!(
        stream,
        "HTTP/1.1 {status}\r\n\
         Content-Type: text/plain; charset=utf-8\r\n\
         Content-Length: {}\r\n\
         Connection: close\r\n\r\n{status}",
        status.len()
    )
}

#[cfg(test)]
mod tests {
    use super::{listen, serve};
    use std::fs;
    use std::io::{Read, Write};
    use std::net::TcpStream;
    use std::thread;

    #[test]
    fn serves_the_folder_and_nothing_above_it() {
        let outer = std::env::temp_dir().join(format!("nctape-http-{}", std::process::id()));
        let folder = outer.join("dist");
        fs::create_dir_all(&folder).expect("a folder in the temporary folder");
        fs::write(outer.join("secret.txt"), "secret").expect("a file beside the site");
        fs::write(folder.join("a.wasm"), b"\0asm").expect("a file of the site");
        let listener = listen(Some(0), 0).expect("a free port");
        let address = listener.local_addr().expect("its address");
        thread::spawn(move || serve(&listener, &folder));
        let get = |target: &str| {
            let mut stream = TcpStream::connect(address).expect("a connection");
            write!(stream, "GET {target} HTTP/1.1\r\nHost: here\r\n\r\n").expect("a request");
            let mut answer = String::new();
            stream.read_to_string(&mut answer).expect("an answer");
            answer
        };

        let wasm = get("/a.wasm");
        assert!(wasm.starts_with("HTTP/1.1 200 OK\r\n"), "{wasm}");
        assert!(wasm.contains("Content-Type: application/wasm\r\n"));
        assert!(wasm.contains("Content-Length: 4\r\n"));
        assert!(wasm.ends_with("\r\n\r\n\0asm"));
        assert!(get("/b.wasm").starts_with("HTTP/1.1 404 "));
        assert!(get("/../secret.txt").starts_with("HTTP/1.1 400 "));
        #[cfg(unix)]
        {
            let link = outer.join("dist/link.txt");
            std::os::unix::fs::symlink(outer.join("secret.txt"), link).expect("a link");
            assert!(get("/link.txt").starts_with("HTTP/1.1 404 "));
        }
        fs::remove_dir_all(&outer).expect("the folder is removed");
    }

    #[test]
    fn takes_another_port_where_the_usual_one_is_taken() {
        let first = listen(Some(0), 0).expect("a free port");
        let taken = first.local_addr().expect("its address").port();
        assert!(listen(None, taken).is_ok());
        assert!(listen(Some(taken), 0).is_err());
    }
}
