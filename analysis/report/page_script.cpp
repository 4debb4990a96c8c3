#include "analysis/report/page_parts.hpp"

namespace bimodal::analysis {

/// Without the letters that XML would read as markup.
std::string_view page_script() {
  return R"(
(function () {
  'use strict';
  var data = JSON.parse(document.getElementById('trial-data').textContent);
  var told = document.getElementById('told');
  var panel = document.createElement('section');
  var opener = null;
  panel.className = 'listed';
  function make(name, text) {
    var element = document.createElement(name);
    element.textContent = text;
    return element;
  }
  function close() {
    panel.remove();
    told.textContent = 'List closed.';
    if (opener) { opener.focus(); }
    opener = null;
  }
  function conditionsOf(figure, side) {
    if (!side) { return [figure.dataset.condition]; }
    if (side === 'both') { return [figure.dataset.first, figure.dataset.second]; }
    return [figure.dataset[side]];
  }
  function trialsOf(unitName, conditions, wanted) {
    var unit = data.units.indexOf(unitName);
    var numbers = conditions.map(function (name) { return data.conditions.indexOf(name); });
    return data.trials.filter(function (trial) {
      if (!numbers.includes(trial[1])) { return false; }
      return wanted(data.words[trial[2]][1 + unit], trial[6 + unit]);
    });
  }
  function row(cells, name) {
    var line = document.createElement('tr');
    cells.forEach(function (text) {
      var cell = make(name, text);
      if (name === 'th') { cell.scope = 'col'; }
      line.append(cell);
    });
    return line;
  }
  function timing(flagged) {
    if (flagged === null) { return 'not known'; }
    return flagged ? 'flagged: not as planned' : 'as planned';
  }
  function list(figure, from, title, conditions, wanted) {
    var trials = trialsOf(figure.dataset.unit, conditions, wanted);
    var table = document.createElement('table');
    var head = document.createElement('thead');
    var body = document.createElement('tbody');
    var heading = title + (conditions.length === 1 ? ', condition ' : ', conditions ') +
      conditions.join(' and ') + ': ' + trials.length + (trials.length === 1 ? ' trial' : ' trials');
    var button = make('button', 'Close');
    head.append(row(['Participant', 'Condition', 'Trial', 'Word', 'Answer', 'Timing'], 'th'));
    trials.forEach(function (trial) {
      body.append(row([data.participants[trial[0]], data.conditions[trial[1]], trial[4],
        data.words[trial[2]][0],
        data.answers[trial[3]] === '' ? '(blank)' : data.answers[trial[3]],
        timing(trial[5])], 'td'));
    });
    table.append(make('caption', heading), head, body);
    button.type = 'button';
    button.addEventListener('click', close);
    panel.textContent = '';
    panel.append(button, table);
    panel.setAttribute('aria-label', heading);
    figure.after(panel);
    opener = from;
    told.textContent = heading;
    button.focus();
  }
  function openCell(figure, cell) {
    var labels = cell.dataset.cell.split(' ');
    var stimulus = data.labels.indexOf(labels[0]);
    var response = data.labels.indexOf(labels[1]);
    list(figure, cell, labels[0] + ' answered ' + labels[1],
      conditionsOf(figure, cell.dataset.side), function (presented, answered) {
        return presented === stimulus ? [].concat(answered).includes(response) : false;
      });
  }
  function neighbour(cells, cell, key) {
    var at = cells.indexOf(cell);
    if (key === 'ArrowRight') { return cells[at + 1]; }
    if (key === 'ArrowLeft') { return cells[at - 1]; }
    var column = cells.filter(function (other) {
      return other.getAttribute('x') === cell.getAttribute('x') ?
        other.dataset.side === cell.dataset.side : false;
    });
    at = column.indexOf(cell);
    if (key === 'ArrowDown') { return column[at + 1]; }
    return key === 'ArrowUp' ? column[at - 1] : undefined;
  }
  function onKey(figure, cells, cell, event) {
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      openCell(figure, cell);
      return;
    }
    var next = neighbour(cells, cell, event.key);
    if (!next) { return; }
    event.preventDefault();
    cell.setAttribute('tabindex', '-1');
    next.setAttribute('tabindex', '0');
    next.focus();
  }
  function addChoice(figure, line, name, wanted) {
    var conditions = conditionsOf(figure);
    var count = trialsOf(figure.dataset.unit, conditions, wanted).length;
    if (count === 0) { return; }
    var button = make('button', name + ' (' + count + ')');
    button.type = 'button';
    button.addEventListener('click', function () {
      list(figure, button, name, conditions, wanted);
    });
    line.append(button);
  }
  document.querySelectorAll('figure[data-unit]').forEach(function (figure) {
    var cells = Array.from(figure.querySelectorAll('rect[data-cell]'));
    var line = make('p', 'Click a cell to list its trials; by keyboard: arrows, then Enter.');
    figure.querySelector('svg').setAttribute('role', 'group');
    cells.forEach(function (cell, index) {
      cell.setAttribute('tabindex', index === 0 ? '0' : '-1');
      cell.setAttribute('role', 'button');
      cell.setAttribute('aria-label', cell.querySelector('title').textContent);
      cell.addEventListener('click', function () { openCell(figure, cell); });
      cell.addEventListener('keydown', function (event) { onKey(figure, cells, cell, event); });
    });
    line.className = 'choices';
    figure.append(line);
    if (!figure.dataset.condition) { return; }
    addChoice(figure, line, 'Ambiguous, left out', function (presented, answered) {
      return presented === -1 ? false : answered === -1;
    });
    addChoice(figure, line, 'Words without such a phone', function (presented) {
      return presented === -1;
    });
  });
  document.addEventListener('keydown', function (event) {
    if (event.key === 'Escape') { if (opener) { close(); } }
  });
}());
)";
}

}  // namespace bimodal::analysis
