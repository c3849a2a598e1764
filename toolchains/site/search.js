// The search: an index in a script, which a browser loads from file://, too, when the field is used for the first time.
"use strict";
(() => {
  const field = document.getElementById("search");
  const list = document.getElementById("found");
  const top = document.body.dataset.top;
  const most = 20;
  let index = null;  // [{title, page, group, text, lower…}]
  let chosen = -1;

  // Of a key, `nodes.NAME.rate`, the last word counts as its title. `begins`: where words begin in the title.
  function entryOf([title, page, group, text]) {
    const key = group.endsWith("key");
    const name = key ? title.split(".").at(-1) : title;
    const begins = [...name.matchAll(/[A-Z]?[a-z0-9]+|[A-Z]+/g)].map(match => match.index);
    const lowText = (key ? title + " " + text : text).toLowerCase();
    return {title, page, group, text, low: name.toLowerCase(), begins, lowText};
  }

  function load() {
    if (index !== null) return;
    index = [];
    const script = document.createElement("script");
    script.src = top + "index-of-search.js";
    script.onload = () => {
      index = globalThis.siteIndex.map(entryOf);
      show();
    };
    document.head.append(script);
  }

  // A title that is the word comes first, then one that begins with it; then what is in titles, then in texts.
  function score(entry, words) {
    let sum = 0;
    for (const word of words) {
      const at = entry.low.indexOf(word);
      if (entry.low === word)
        sum += entry.group === "manifest key" ? 40 : 200;
      else if (at === 0)
        sum += 60;
      else if (at > 0)
        sum += entry.begins.includes(at) ? 40 : 20;
      else if (entry.lowText.includes(word))
        sum += 5;
      else
        return 0;
    }
    const bonus = {entity: 30, code: 12, command: 25, key: 15, "manifest key": 0, page: 8}[entry.group] ?? 0;
    return sum + (sum > 5 * words.length ? bonus : 0) - Math.min(entry.title.length, 60) / 10;
  }

  function excerpt(entry, words) {
    const at = Math.max(0, ...words.map(word => entry.lowText.indexOf(word)));
    const from = Math.max(0, at - 30);
    return (from > 0 ? "…" : "") + entry.text.slice(from, from + 110);
  }

  function choose(number) {
    const items = [...list.children];
    chosen = items.length ? (number + items.length) % items.length : -1;
    items.forEach((item, i) => item.setAttribute("aria-selected", String(i === chosen)));
    items[chosen]?.scrollIntoView({block: "nearest"});
  }

  function show() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = index.map(entry => [score(entry, words), entry])
                      .filter(([points]) => points > 0)
                      .sort((a, b) => b[0] - a[0])
                      .slice(0, most);
    list.replaceChildren(...found.map(([, entry]) => {
      const item = document.createElement("li");
      item.setAttribute("role", "option");
      const link = document.createElement("a");
      link.href = top + entry.page;
      const title = document.createElement("b");
      title.textContent = entry.title;
      const small = document.createElement("small");
      small.textContent = `${entry.group}: ${excerpt(entry, words)}`;
      link.append(title, small);
      item.append(link);
      return item;
    }));
    if (words.length && !found.length) {
      const none = document.createElement("li");
      none.className = "none";
      none.textContent = "nothing found";
      list.append(none);
    }
    const open = words.length > 0;
    list.hidden = !open;
    field.setAttribute("aria-expanded", String(open));
    choose(found.length ? 0 : -1);
  }

  field.addEventListener("focus", load);
  field.addEventListener("input", () => {
    load();
    show();
  });
  field.addEventListener("keydown", event => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      choose(chosen + (event.key === "ArrowDown" ? 1 : -1));
      event.preventDefault();
    } else if (event.key === "Enter") {
      list.children[chosen]?.querySelector("a")?.click();
    } else if (event.key === "Escape") {
      field.value = "";
      show();
      field.blur();
    }
  });
  addEventListener("keydown", event => {
    if (event.key === "/" && !/INPUT|TEXTAREA/.test(document.activeElement.tagName)) {
      field.focus();
      event.preventDefault();
    }
  });
  addEventListener("click", event => {
    if (!event.target.closest(".search")) list.hidden = true;
  });
})();
