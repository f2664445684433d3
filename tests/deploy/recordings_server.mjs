// A small stand-in for a robot's HTTP API of recordings, which can fail on request.
import http from "node:http";
import { crc32 } from "../../robot/deploy/crc32.mjs";

const hex = (bytes) => crc32(bytes).toString(16).padStart(8, "0");

/**
 * Serves `sessions`: {id: {files: {name: Buffer}, state, kept, unread, schemas: {name: schema}}} on loopback until test
 * `t` ends. The first `unread` lists do not know a session's streams yet. `asked` becomes the list of all requests,
 * "METHOD path range". `fail(path, response)`, which may be set, answers in its place when it returns true. `token` is
 * the control token.
 */
export async function serveRecordings(t, sessions, token = "12345678") {
  const served = { asked: [], token };
  const sentence = (response, status, error) => response.writeHead(status).end(JSON.stringify({ error }));

  const lists = new Map(); // session -> how many lists it was in
  const describe = ([session, { files, state = "complete", kept = false, unread = 0, schemas = {} }]) => {
    const before = lists.get(session) ?? 0;
    lists.set(session, before + 1);
    const read = before >= unread;
    const streams = Object.keys(files).filter((name) => read && name.endsWith(".mcap"));
    return {
      session,
      state,
      read,
      kept,
      start_ns: "1795321006961272091",
      streams: streams.map((file) => ({
        file,
        schema: schemas[file] ?? "foresight.Ball",
        size_bytes: files[file].length,
      })),
    };
  };

  const sendFile = (request, response, bytes) => {
    const from = Number(/^bytes=(\d+)-$/.exec(request.headers.range ?? "")?.[1] ?? 0);
    const head = from > 0 ? { "content-range": `bytes ${from}-${bytes.length - 1}/${bytes.length}` } : {};
    response
      .writeHead(from > 0 ? 206 : 200, { ...head, "content-length": bytes.length - from })
      .end(bytes.subarray(from));
  };

  const server = http.createServer((request, response) => {
    const { pathname: path, searchParams } = new URL(request.url, "http://robot");
    served.asked.push([request.method, path, request.headers.range].filter(Boolean).join(" "));
    if (served.fail?.(path, response)) return;
    if (path === "/api/sessions")
      return response.end(JSON.stringify({ sessions: Object.entries(sessions).map(describe) }));
    const [, id, name] = /^\/(?:api\/sessions|logs)\/([^/]+)(?:\/files(?:\/(.+))?)?$/.exec(path) ?? [];
    const session = sessions[id];
    if (!session) return sentence(response, 404, `there is no session '${id}'`);
    if (session.state === "recording") return sentence(response, 409, "it is being recorded");
    if (request.method === "DELETE") {
      if (searchParams.get("token") !== token) return sentence(response, 401, "the control token is missing or wrong");
      if (session.kept) return sentence(response, 409, "it is kept");
      delete sessions[id];
      return response.writeHead(204).end();
    }
    if (name) return sendFile(request, response, session.files[name]);
    const files = Object.entries(session.files).map(([name, bytes]) => ({
      name,
      size_bytes: bytes.length,
      crc32: hex(bytes),
    }));
    return response.end(JSON.stringify({ session: id, files }));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  served.port = server.address().port;
  t.after(() => (server.closeAllConnections(), server.close()));
  return served;
}
