// Theme, search and the buttons that copy a command. Without it, everything on the page can still be read.
(() => {
  "use strict";
  const root = document.documentElement;
  const kept = {
    get: () => { try { return localStorage.getItem("badlog-site-theme"); } catch { return null; } },
    set: value => { try { localStorage.setItem("badlog-site-theme", value); } catch { /* Not kept, then. */ } },
  };
  const theme = kept.get();
  if (theme === "dark" || theme === "light") root.dataset.theme = theme;

  /** Loads a script of the site once; a page on disk may not fetch anything else. */
  const scripts = new Map();
  const load = name => {
    if (!scripts.has(name)) {
      scripts.set(name, new Promise((resolve, reject) => {
        const script = document.createElement("script");
        script.src = document.body.dataset.root + name;
        script.onload = resolve;
        script.onerror = () => reject(new Error(name + " could not be loaded."));
        document.head.append(script);
      }));
    }
    return scripts.get(name);
  };

  let index = null;
  const searchIndex = async () => {
    if (index) return index;
    await Promise.all([load("minisearch.js"), load("search-index.js")]);
    const search = new MiniSearch({
      fields: ["heading", "title", "text"],
      storeFields: ["address", "title", "heading", "text"],
      searchOptions: { boost: { heading: 4, title: 2 }, prefix: true, fuzzy: term => term.length > 4 ? 0.2 : 0, combineWith: "AND" },
    });
    search.addAll(window.searchIndex.map(([address, title, heading, text], id) => ({ id, address, title, heading, text })));
    return index = search;
  };

  /** The words around the first match, with all matches marked. */
  const excerpt = (text, terms) => {
    const found = terms.map(term => text.toLowerCase().indexOf(term.toLowerCase())).filter(at => at >= 0);
    const from = Math.max(0, (found.length ? Math.min(...found) : 0) - 40);
    const part = (from > 0 ? "…" : "") + text.slice(from, from + 160);
    const line = document.createElement("small");
    const pattern = new RegExp("(" + terms.map(term => term.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|") + ")", "gi");
    part.split(pattern).forEach((piece, i) => {
      if (i % 2 === 0) return line.append(piece);
      const mark = document.createElement("mark");
      mark.textContent = piece;
      line.append(mark);
    });
    return line;
  };

  document.addEventListener("DOMContentLoaded", () => {
    const button = document.querySelector(".theme");
    button.hidden = false;
    button.addEventListener("click", () => {
      const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
      root.dataset.theme = dark ? "light" : "dark";
      kept.set(root.dataset.theme);
    });

    if (navigator.clipboard) {
      for (const block of document.querySelectorAll("pre")) {
        const copy = document.createElement("button");
        copy.className = "copy";
        copy.type = "button";
        copy.textContent = "Copy";
        const code = block.textContent;
        copy.addEventListener("click", async () => {
          // From a terminal session, only what a person types.
          const typed = code.split("\n").filter(line => line.startsWith("$ ")).map(line => line.slice(2));
          await navigator.clipboard.writeText(typed.length ? typed.join("\n") : code);
          copy.textContent = "Copied";
          setTimeout(() => { copy.textContent = "Copy"; }, 1500);
        });
        block.append(copy);
      }
    }

    const form = document.querySelector(".search");
    const input = form.querySelector("input");
    const results = form.querySelector(".results");
    const close = () => { results.hidden = true; };
    const say = text => {
      const line = document.createElement("p");
      line.textContent = text;
      results.replaceChildren(line);
    };
    const search = async () => {
      const query = input.value.trim();
      if (query.length < 2) return close();
      let found;
      try {
        found = (await searchIndex()).search(query).slice(0, 20);
      } catch (failure) {
        results.hidden = false;
        return say("The search does not work here: " + failure.message);
      }
      if (query !== input.value.trim()) return;
      if (found.length === 0) {
        say("Nothing found. Check the spelling, or search for fewer words.");
      } else {
        results.replaceChildren(...found.map(hit => {
          const link = document.createElement("a");
          link.href = document.body.dataset.root + hit.address;
          link.append(hit.heading === hit.title ? hit.title : hit.heading + " – " + hit.title, excerpt(hit.text, hit.terms));
          link.addEventListener("click", close);
          return link;
        }));
      }
      results.hidden = false;
    };
    input.addEventListener("focus", () => searchIndex().catch(() => {}), { once: true });
    input.addEventListener("input", search);
    form.addEventListener("submit", event => {
      event.preventDefault();
      results.querySelector("a")?.click();
    });
    document.addEventListener("keydown", event => {
      const links = [...results.querySelectorAll("a")];
      if (event.key === "/" && !event.target.closest("input, textarea") && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        input.select();
        input.focus();
      } else if (event.key === "Escape" && !results.hidden) {
        close();
        input.focus();
      } else if ((event.key === "ArrowDown" || event.key === "ArrowUp") && !results.hidden && form.contains(event.target)) {
        event.preventDefault();
        const next = links.indexOf(document.activeElement) + (event.key === "ArrowDown" ? 1 : -1);
        (next < 0 ? input : links[Math.min(next, links.length - 1)])?.focus();
      }
    });
    document.addEventListener("click", event => { if (!form.contains(event.target)) close(); });
    const asked = new URLSearchParams(location.search).get("q");
    if (asked) {
      input.value = asked;
      search();
    }
  });
})();
