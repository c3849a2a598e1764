// Client of the server of `eagerx-gen serve`. It sends one request at a time, so that each edit refers to the newest
// revision. generator/tools/serve/README.md describes the protocol.

const kJson = {
  "Content-Type": "application/json"
};
const kPatience_ms = 2000;  // delay before the next request to a server that did not answer

export class EditClient {
  /** `changed(why)` is called after each new state. `ask` is fetch, or its replacement in a test. */
  constructor(changed, ask = (address, options) => fetch(address, options)) {
    Object.assign(this, {changed, ask, state: null, before: "", waiting: Promise.resolve(), lost: false});
  }

  /** Runs an action after all earlier ones. An action that fails does not stop those that follow. */
  inTurn(action) {
    const done = this.waiting.then(action);
    this.waiting = done.catch(() => {});
    return done;
  }

  /** {status, body} of a response. Status 0: no response. */
  async call(address, body) {
    const options = body === undefined ? {} : {method: "POST", headers: kJson, body: JSON.stringify(body)};
    try {
      const answer = await this.ask(address, options);
      return {status: answer.status, body: await answer.json()};
    } catch (problem) {
      return {
        status: 0,
        body: {error: "no answer: `eagerx-gen serve` does not run any more", help: String(problem.message)}
      };
    }
  }

  take(state, why) {
    const known = this.state;
    if (known && state.page === undefined) state.page = known.page;
    // Text before its last change, to highlight the difference.
    if (known && known.text !== state.text) this.before = known.text;
    if (!known) this.before = state.text;
    this.state = state;
    this.changed(why);
  }

  async get(name) {
    const {status, body} = await this.call(`./${name}`);
    return status === 200 ? body : null;
  }

  load(why = "") {
    return this.inTurn(async () => {
      const state = await this.get("state");
      if (state) this.take(state, why);
      return state !== null;
    });
  }

  /** "" on success, otherwise a message for the user. `done` is the message that success leaves. */
  post(name, body, done = "") {
    return this.inTurn(async () => {
      const answer = await this.call(`./${name}`, {revision: this.state.revision, ...body});
      if (answer.status === 200) {
        this.take(answer.body, done);
        return "";
      }
      const said = [answer.body.error, answer.body.help].filter(Boolean).join(": ") || `status ${answer.status}`;
      if (answer.body.state) this.take(answer.body.state, said);
      return said;
    });
  }

  edit(edits) {
    return this.post("edit", {edits});
  }

  undo() {
    return this.post("undo", {});
  }

  redo() {
    return this.post("redo", {});
  }

  /** Saves positions of boxes, which do not create a revision. */
  places(places) {
    return this.inTurn(() => {
      this.state.layout = places;
      return this.call("./layout", {places});
    });
  }

  /** Waits for the next change that this page did not make. Returns false if there is no response. */
  async follow() {
    const {status, body} = await this.call(`./changes?revision=${this.state.revision}`);
    const wasLost = this.lost;
    this.lost = status !== 200;
    if (this.lost !== wasLost) this.changed(this.lost ? body.error ?? `status ${status}` : "");
    if (this.lost) return false;
    await this.inTurn(() => {});  // an edit of this page may be in progress
    if (body.revision !== this.state.revision)
      await this.load("The file was changed on the disk: this is what it says now.");
    return true;
  }

  async followForEver(later = (call) => setTimeout(call, kPatience_ms)) {
    while (await this.follow()) continue;
    later(() => this.followForEver(later));
  }
}
