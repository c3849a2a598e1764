// A client of the Language Server Protocol over the standard input and output of a process. It knows nothing of VS
// Code.
"use strict";
const {spawn} = require("node:child_process");

const HEADER_END = "\r\n\r\n";

class Client {
  /** `on`: {diagnostics(params), request(method, params), ended(code)}, all optional. */
  constructor(command, options, on = {}) {
    this.on = on;
    this.waiting = new Map();  // by id: {resolve, reject}
    this.lastId = 0;
    this.bytes = Buffer.alloc(0);
    this.process = spawn(command, options, {stdio: ["pipe", "pipe", "pipe"]});
    this.said = "";
    this.process.stderr.on("data", (text) => {
      this.said = (this.said + text).slice(-2000);
    });
    this.process.stdout.on("data", (bytes) => this.take(bytes));
    this.process.stdin.on("error", () => {});  // `exit` reports the end of the process
    this.process.on("error", (error) => this.end(error.message));
    this.process.on("exit", (code) => this.end(`it ended with ${code}${this.said ? `: ${this.said}` : ""}`));
  }

  end(why) {
    if (this.ended) return;
    this.ended = true;
    for (const {reject} of this.waiting.values()) reject(new Error(why));
    this.waiting.clear();
    if (this.on.ended) this.on.ended(why);
  }

  take(bytes) {
    this.bytes = Buffer.concat([this.bytes, bytes]);
    for (;;) {
      const end = this.bytes.indexOf(HEADER_END);
      if (end < 0) return;
      const length = /content-length: *(\d+)/i.exec(this.bytes.toString("latin1", 0, end));
      if (!length) return this.end("the input is not a message of the Language Server Protocol");
      const begin = end + HEADER_END.length;
      if (this.bytes.length < begin + Number(length[1])) return;
      const content = this.bytes.toString("utf8", begin, begin + Number(length[1]));
      this.bytes = this.bytes.subarray(begin + Number(length[1]));
      try {
        this.dispatch(JSON.parse(content));
      } catch (error) {
        return this.end(error.message);
      }
    }
  }

  dispatch(message) {
    if (message.method === undefined) {
      const waiting = this.waiting.get(message.id);
      if (!waiting) return;
      this.waiting.delete(message.id);
      if (message.error)
        waiting.reject(new Error(message.error.message));
      else
        waiting.resolve(message.result);
    } else if (message.id !== undefined) {
      if (this.on.request) this.on.request(message.method, message.params);
      this.send({id: message.id, result: null});
    } else if (message.method === "textDocument/publishDiagnostics" && this.on.diagnostics) {
      this.on.diagnostics(message.params);
    }
  }

  send(message) {
    if (this.ended) return;
    const content = Buffer.from(JSON.stringify({jsonrpc: "2.0", ...message}));
    this.process.stdin.write(`Content-Length: ${content.length}\r\n\r\n`);
    this.process.stdin.write(content);
  }

  tell(method, params) {
    this.send({method, params});
  }

  ask(method, params) {
    if (this.ended) return Promise.reject(new Error("the language server has ended"));
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, {resolve, reject});
      this.send({id, method, params});
    });
  }

  async stop() {
    if (this.ended) return;
    const gone = new Promise((resolve) => this.process.once("exit", resolve));
    try {
      await this.ask("shutdown");
      this.tell("exit");
    } catch {
      this.process.kill();
    }
    await gone;
  }
}

module.exports = {Client};
