// The controls beside the picture: plain HTML, so that keyboards and screen readers know them.

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

export function group(legend, ...children) {
  return element('fieldset', {}, element('legend', {}, legend), ...children);
}

export function button(text, title, onclick) {
  return element('button', { type: 'button', title, onclick }, text);
}

export function select(label, options, value, onchange) {
  const box = element('select', { onchange: () => onchange(box.value) });
  for (const [key, text] of options) box.append(element('option', { value: key }, text));
  box.value = value;
  return { object: element('label', {}, element('span', {}, label), box), box };
}

// A slider with its value in words, which `describe` makes.
export function slider(label, { min, max, step, value }, describe, onchange) {
  const words = element('output');
  const range = element('input', { type: 'range', min, max, step });
  const set = (to) => {
    range.value = to;
    words.textContent = describe(Number(range.value));
    range.setAttribute('aria-valuetext', words.textContent);
    onchange(Number(range.value));
  };
  range.addEventListener('input', () => set(range.value));
  set(value);
  return { object: element('label', {}, element('span', {}, label, ' ', words), range), set };
}

export function checkbox(label, checked, onchange, color) {
  const box = element('input', { type: 'checkbox', onchange: () => onchange(box.checked) });
  box.checked = checked;
  const sample = color ? [element('i', { style: `background:${color}`, 'aria-hidden': 'true' })] : [];
  onchange(checked);
  return element('label', { class: 'check' }, box, ...sample, label);
}

export { element };
