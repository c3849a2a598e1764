// As much of a browser as the page's modules ask for, without layout or paint: elements with text, classes, attributes
// and listeners; canvases that note what is called; frames and timers that wait until a test lets them pass.

const kWidth = 800, kHeight = 600;

class Text {
  constructor(text) {
    this.data = text;
  }
  get textContent() {
    return this.data;
  }
  remove() {
    this.parentElement?.take(this);
  }
}

/** Canvas contexts: every call and setting is a row of `calls`. */
function contextOf() {
  const calls = [];
  return new Proxy({calls}, {
    get: (target, name) => name in target ? target[name] : (...words) => calls.push([name, ...words]),
    set: (target, name, value) => {
      calls.push([`${String(name)} =`, value]);
      target[name] = value;
      return true;
    }
  });
}

export class Element {
  constructor(tag) {
    Object.assign(
        this, {tagName: tag, childNodes: [], attributes: new Map(), listeners: new Map(), dataset: {}, style: {}});
    Object.assign(
        this, {hidden: false, id: "", title: "", className: "", value: "", checked: false, tabIndex: -1, type: ""});
    this.parentElement = null;
    this.classList = {
      contains: (name) => this.classes.has(name),
      add: (name) => this.classList.toggle(name, true),
      remove: (name) => this.classList.toggle(name, false),
      toggle: (name, on = !this.classes.has(name)) => {
        const classes = this.classes;
        classes[on ? "add" : "delete"](name);
        this.setClass([...classes].join(" "));
        return on;
      }
    };
  }

  // Of SVG, the class is an attribute.
  get classes() {
    return new Set((this.attributes.get("class") ?? this.className).split(" ").filter(Boolean));
  }
  setClass(text) {
    if (this.attributes.has("class"))
      this.attributes.set("class", text);
    else
      this.className = text;
  }

  get textContent() {
    return this.childNodes.map((child) => child.textContent).join("");
  }
  set textContent(text) {
    this.replaceChildren(String(text));
  }
  set innerHTML(_) {
    throw new Error("foreign text may become markup");
  }
  get children() {
    return this.childNodes.filter((child) => child instanceof Element);
  }
  get firstChild() {
    return this.childNodes[0] ?? null;
  }
  get childElementCount() {
    return this.children.length;
  }

  append(...children) {
    for (const child of children) {
      const node = typeof child === "string" ? new Text(child) : child;
      node.remove();
      node.parentElement = this;
      this.childNodes.push(node);
    }
  }
  replaceChildren(...children) {
    for (const child of [...this.childNodes]) this.take(child);
    this.append(...children);
  }
  take(child) {
    this.childNodes.splice(this.childNodes.indexOf(child), 1);
    child.parentElement = null;
  }
  remove() {
    this.parentElement?.take(this);
  }

  setAttribute(name, value) {
    this.attributes.set(name, String(value));
  }
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }

  addEventListener(name, listener) {
    this.listeners.set(name, [...(this.listeners.get(name) ?? []), listener]);
  }
  /** Calls the listeners of this element and of those around it. */
  send(name, event = {}) {
    const whole = {
      target: this,
      button: 0,
      clientX: 100,
      clientY: 100,
      deltaY: 0,
      preventDefault() {},
      pointerId: 1,
      type: name,
      ...event
    };
    for (let at = this; at; at = at.parentElement)
      for (const listener of at.listeners.get(name) ?? []) listener(whole);
    return whole;
  }
  click() {
    this.send("click");
  }
  focus() {
    this.focused = true;
  }
  blur() {}
  select() {}
  setSelectionRange() {}
  contains(other) {
    for (let at = other; at; at = at.parentElement)
      if (at === this) return true;
    return false;
  }
  setPointerCapture() {}
  scrollIntoView() {}
  showModal() {
    this.open = true;
  }
  close() {
    this.open = false;
  }

  /** `tag.class#id`, several of them apart by commas. */
  matches(selector) {
    return selector.split(",").some((one) => {
      const [, tag, rest] = /^\s*([\w-]*)(.*?)\s*$/.exec(one);
      const names = rest.match(/[.#][\w-]+/g) ?? [];
      return (!tag || tag === this.tagName) &&
          names.every((name) => name[0] === "#" ? this.id === name.slice(1) : this.classes.has(name.slice(1)));
    });
  }
  closest(selector) {
    for (let at = this; at; at = at.parentElement)
      if (at.matches(selector)) return at;
    return null;
  }
  /** One without combinators. */
  querySelectorAll(selector) {
    return this.children.flatMap(
        (child) => [...(child.matches(selector) ? [child] : []), ...child.querySelectorAll(selector)]);
  }
  querySelector(selector) {
    return this.querySelectorAll(selector)[0] ?? null;
  }

  getBoundingClientRect() {
    return {x: 0, y: 0, left: 0, top: 0, right: kWidth, bottom: kHeight, width: kWidth, height: kHeight};
  }
  getContext() {
    return (this.context ??= contextOf());
  }
  get valueAsNumber() {
    return this.value === "" ? NaN : Number(this.value);
  }
}

const kIds = ["title", "summary", "search", "found", "theme", "keys", "tabs", "views", "inspector", "help", "tip"];

/** The globals of a page with this block of data. `frames` and `timers` are what waits. */
export function browserWith(data) {
  const body = new Element("body"), root = new Element("html"), frames = [], timers = [];
  root.append(body);
  const ids = new Map(kIds.map((id) => [id, Object.assign(new Element(id === "search" ? "input" : "div"), {id})]));
  body.append(...ids.values());
  ids.set("data", Object.assign(new Element("script"), {textContent: JSON.stringify(data)}));
  const outside = new Element("window");
  const document = Object.assign(new Element("document"), {
    documentElement: root,
    body,
    activeElement: body,
    getElementById: (id) => ids.get(id) ?? body.querySelector(`#${id}`),
    createElement: (tag) => new Element(tag),
    createElementNS: (_, tag) => new Element(tag),
    createTextNode: (text) => new Text(text)
  });
  const globals = {
    document,
    Node: {[Symbol.hasInstance]: (value) => value instanceof Element || value instanceof Text},
    location: {hash: "", host: "127.0.0.1:1", search: "?key=0"},
    history: {replaceState: (state, title, hash) => (globals.location.hash = hash)},
    getComputedStyle: () => ({getPropertyValue: (name) => `<${name}>`}),
    matchMedia: () => new Element("media"),
    requestAnimationFrame: (draw) => frames.push(draw),
    addEventListener: outside.addEventListener.bind(outside),
    ResizeObserver: class {observe() {}},
    innerWidth: kWidth,
    innerHeight: kHeight,
    ImageData: class {}
  };
  globals.window = globals;
  return {globals, frames, timers, body, document};
}

/** Lets all frames that wait pass, and those that they ask for. */
export function passFrames(frames, most = 20) {
  for (let i = 0; i < most && frames.length; ++i)
    for (const draw of frames.splice(0)) draw(16 * i);
}

/** Makes this process such a page, for modules that are imported afterwards. */
export function become(data) {
  const browser = browserWith(data);
  Object.assign(globalThis, browser.globals);
  return browser;
}

/** A block of data with as little as there may be: one node `filter` at 20 Hz that reads the environment at 10 Hz. */
export function smallData() {
  const space = {text: "float32 [2]", numbers: 2, bytes: 8, low: [-1, -1], high: [1, 1]};
  const port = {space, unit: "V", processor: null, sensor: ""};
  const node = {role: "node", type: "Filter", about: "", line: 0, config: [], states: [], object: null};
  const hop = {a: 1, b: 2, newest: {exact: "0", seconds: 0}, oldest: {exact: "0", seconds: 0}};
  const input = {
    ...{
      name: "signal",
      written: "filter.signal",
      from: "actions.u",
      source: [0, 0],
      space,
      window: 1,
      most: 1,
      keep: 1
    },
    ...{
      delay: {exact: "0", seconds: 0},
      longest_delay: null,
      random_delay: null,
      skip: false,
      processor: null,
      ring: 0,
      line: 0
    },
    ...{
      hop, received: {begin: [1], cycle: [0, 1]}
    }
  };
  return {
    info: {
      name: "small",
      engine: "none",
      ages: [],
      budget_ages: [],
      ages_unknown: [],
      link: {messages: []},
      delays: [],
      task: null
    },
    agent: "zero",
    real: "float",
    nodes: [
      {
        ...node,
        name: "environment",
        role: "environment",
        rate: "10",
        rate_class: 1,
        inputs: [],
        outputs: [{...port, name: "u"}]
      },
      {...node, name: "filter", rate: "20", rate_class: 0, inputs: [input], outputs: [{...port, name: "y"}]}
    ],
    objects: [],
    composites: [],
    rings: [{node: 0, output: 0, reader: null, space, needed: 1, messages: 1, bytes: 8, why: ""}],
    channels: [{name: "environment/u", node: 0, output: 0}, {name: "filter/y", node: 1, output: 0}],
    schedule: {
      ...{
        quantum: {exact: "1/20", seconds: 0.05},
        hyperperiod: {exact: "1/10", seconds: 0.1},
        form: "constants",
        slots: 2
      },
      ...{
        asynchronous: false, order: [0, 1], rates: [{rate: "20", period: 1}, {rate: "10", period: 2}]
      }
    },
    drawings: {user: {width: 1, height: 1, boxes: [], wires: []}, engine: {width: 1, height: 1, boxes: [], wires: []}},
    policies: [],
    safety: null,
    source: {name: "small.yaml", lines: []},
    diagnostics: [],
    images: [],
    logs: [],
    shows: ""
  };
}
