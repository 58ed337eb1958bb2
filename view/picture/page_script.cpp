// SPDX-License-Identifier: GPL-3.0-or-later
// The script of pages.
#include "view/picture/markup.hpp"

namespace fathom::picture {

std::string_view page_script() {
  return R"script(
'use strict';
(() => {
  const all = (what) => Array.from(document.querySelectorAll(what));
  const open = (element) => {
    for (let at = element; at; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
  };

  // ---- filters ----
  const filters = new Map();
  all('form.filter').forEach((form) => {
    const items = Array.from(document.getElementById(form.dataset.of).children);
    const words = items.map((item) => (item.querySelector('summary') || item).textContent.toLowerCase());
    const text = form.elements.text, kind = form.elements.kind, told = form.querySelector('output');
    const apply = () => {
      const wanted = text.value.trim().toLowerCase();
      let shown = 0;
      items.forEach((item, i) => {
        const fits = (kind.value === '' || kind.value === item.dataset.kind) ? words[i].includes(wanted) : false;
        item.hidden = !fits;
        if (fits) shown += 1;
      });
      told.textContent = shown + ' of ' + items.length;
    };
    form.addEventListener('input', apply);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.hidden = false;
    filters.set(form.dataset.of, (find, choice) => { text.value = find; kind.value = choice; apply(); });
    apply();
  });
  all('a[data-find]').forEach((link) => link.addEventListener('click', () => {
    const of = link.dataset.of;
    if (filters.has(of)) filters.get(of)(link.dataset.find, link.dataset.choice || '');
    open(document.getElementById(of));
  }));

  // ---- copying ----
  all('button.copy').forEach((button) => {
    const from = document.getElementById(button.dataset.of), told = button.nextElementSibling;
    const tell = (what) => { told.textContent = what; setTimeout(() => { told.textContent = ''; }, 4000); };
    const select = () => {
      open(from);
      window.getSelection().selectAllChildren(from);
      tell(document.execCommand('copy') ? 'copied' : 'selected: copy it by hand');
    };
    button.addEventListener('click', () => {
      if (!navigator.clipboard) return select();
      navigator.clipboard.writeText(from.textContent).then(() => tell('copied'), select);
    });
    button.hidden = false;
  });

  // ---- the features of a row, in the picture ----
  const light = (row) => {
    all('.mark.lit').forEach((mark) => mark.classList.remove('lit'));
    all('tr.lights').forEach((other) => other.classList.toggle('lights', other === row));
    row.classList.add('lights');
    row.dataset.lights.split(' ').forEach((id) => document.getElementById(id).classList.add('lit'));
  };
  all('tr[data-lights]').forEach((row) => {
    for (const when of ['mouseenter', 'focusin', 'click']) row.addEventListener(when, () => light(row));
  });

  // ---- links into what is folded ----
  const follow = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    open(target);
    target.scrollIntoView({ block: 'nearest' });
  };
  window.addEventListener('hashchange', follow);
  follow();
})();
)script";
}

}  // namespace fathom::picture
