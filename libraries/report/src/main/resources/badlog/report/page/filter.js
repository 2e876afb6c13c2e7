(() => {
  const form = document.getElementById('filter');
  const logs = new Map();
  for (const part of document.querySelectorAll('[data-log]')) {
    const log = logs.get(part.dataset.log) || { parts: [], items: [], name: '', type: part.dataset.type };
    logs.set(part.dataset.log, log);
    log.parts.push(part);
    const heading = part.querySelector('h3');
    if (heading) log.name = heading.parentElement.textContent.toLowerCase();
    for (const item of part.querySelectorAll('li')) log.items.push({ item, level: +item.dataset.level, text: item.textContent.toLowerCase() });
  }
  const table = document.querySelector('.overview');
  const rows = [...table.querySelectorAll('[data-log]')];
  const groups = [...table.querySelectorAll('.group')];
  const order = () => {
    const isGrouped = form.elements.order && form.elements.order.value === 'event';
    if (isGrouped) {
      for (const row of [...rows].sort((one, other) => one.dataset.place - other.dataset.place)) groups[row.dataset.group].append(row);
    } else {
      table.tBodies[0].append(...rows);
    }
    for (const group of groups) group.hidden = !group.querySelector('[data-log]:not([hidden])');
  };
  const apply = () => {
    const words = form.elements.words.value.toLowerCase().split(/\s+/).filter(word => word);
    const least = +form.elements.level.value;
    const type = form.elements.type ? form.elements.type.value : '';
    const isFiltered = words.length > 0 || least > 0;
    let matches = 0, findings = 0;
    for (const log of logs.values()) {
      let shown = 0;
      for (const { item, level, text } of log.items) {
        const isShown = level >= least && words.every(word => text.includes(word) || log.name.includes(word));
        item.hidden = !isShown;
        if (isShown) shown++;
      }
      const isNamed = least === 0 && words.every(word => log.name.includes(word));
      const isShown = (type === '' || log.type === type) && (!isFiltered || shown > 0 || isNamed);
      for (const part of log.parts) part.hidden = !isShown || (part.matches('article') && shown === 0);
      if (isShown) { matches++; findings += shown; }
    }
    order();
    form.elements.found.value = matches + ' of ' + logs.size + (logs.size === 1 ? ' match' : ' matches') + ', ' + findings + (findings === 1 ? ' entry' : ' entries');
  };
  form.hidden = false;
  form.addEventListener('input', apply);
  form.addEventListener('submit', event => event.preventDefault());
  apply();
})();
