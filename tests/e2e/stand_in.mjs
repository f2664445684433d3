// A viewer in front of a program: its files come from a folder, all other answers from the program, whose headers they
// get. So the page can be tested as it was just built, without building the programs again.
import { readFileSync } from "node:fs";
import http from "node:http";
import net from "node:net";
import { extname, join, normalize } from "node:path";

const kTypes = { ".css": "text/css", ".html": "text/html", ".js": "text/javascript", ".svg": "image/svg+xml" };

/** The bytes of a file of the viewer; undefined if the program answers the request. */
function fileOf(folder, path) {
  const name = normalize(decodeURIComponent(path.split("?")[0]));
  if (name.startsWith("/logs") || name.startsWith("/api")) return undefined;
  try {
    const file = join(folder, name === "/" ? "index.html" : name);
    return { bytes: readFileSync(file), type: kTypes[extname(file)] ?? "application/octet-stream" };
  } catch {
    return undefined;
  }
}

/** Starts it in front of the `program` at {host, port}; returns its own port. It ends with the test, also when the program dies. */
export async function standIn(t, atEnd, folder, program) {
  const policy = (await fetch(`http://${program.host}:${program.port}/`)).headers.get("content-security-policy");
  const sockets = new Set();

  const server = http.createServer((request, response) => {
    const file = fileOf(folder, request.url);
    if (file) {
      response.writeHead(200, {
        "Content-Type": file.type,
        "Content-Security-Policy": policy,
        "Referrer-Policy": "no-referrer",
      });
      return response.end(file.bytes);
    }
    const asked = http.request(
      { ...program, path: request.url, method: request.method, headers: request.headers, agent: false },
      (answer) => {
        response.writeHead(answer.statusCode, answer.headers);
        answer.pipe(response);
      },
    );
    asked.on("error", () => request.socket.destroy());
    request.pipe(asked);
  });
  server.on("connection", (socket) => {
    sockets.add(socket);
    socket.on("error", () => {});
    socket.on("close", () => sockets.delete(socket));
  });

  // a WebSocket is passed on byte by byte
  server.on("upgrade", (request, socket, head) => {
    const asked = net.connect(program, () => {
      const lines = request.rawHeaders.map((text, i) => (i % 2 === 0 ? `${text}: ` : `${text}\r\n`)).join("");
      asked.write(`${request.method} ${request.url} HTTP/1.1\r\n${lines}\r\n`);
      if (head.length > 0) asked.write(head);
      asked.pipe(socket);
      socket.pipe(asked);
    });
    for (const [one, other] of [
      [asked, socket],
      [socket, asked],
    ]) {
      one.on("error", () => other.destroy());
      one.on("close", () => other.destroy());
    }
  });

  await new Promise((done) => server.listen(0, program.host, done));
  atEnd(t, () => {
    for (const socket of sockets) socket.destroy();
    return new Promise((done) => server.close(done));
  });
  return server.address().port;
}
