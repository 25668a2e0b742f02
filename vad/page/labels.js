// The labels of a picture that a hand moves. Each stands beside its dot, where it stood before while
// that place is free, else at the nearest free one, to which it glides. Letters of dots that lie
// close together make one label. A label without room is hidden.
//
// labels(texts, data, out, counts) -> {place, hidden}. place(calm) places all texts for the
// outputs of a pose, and tells whether any is still on its way; calm lets each be there at once. A
// place is a share of the way around the dot and a number among the label's distances.

const APART = 0.006, BESIDE = 0.02, CLEAR = 0.006, TIGHT = 0.001, LEADING = 0.046, BETWEEN = 0.02, IN_ROW = 4;
const STEP = 10 / 720, JUMP = 11 / 720, JOINED = 12 / 720, PARTED = 15 / 720, PLACES = 40, OWN = 1.06, SELDOM = 4, REACH = 0.2;
const THIN = 0.002, VANISHES = 1e-6;
const SVG = "http://www.w3.org/2000/svg";

// Whether a letter at a place goes with its part, as that has no length: apart are its other ends.
function vanished(out, apart, u, v) {
  for (let n = 0; n < apart.length; n += 2)
    if (!(Math.hypot(out[apart[n]] - u, out[apart[n + 1]] - v) > VANISHES)) return true;
  return false;
}

function labels(texts, data, out, counts) {
  const [unit, , top] = data.page, groups = new Map(), joined = new Set();
  let hidden = 0, tick = 0, softly = false;

  const all = data.labels.map(([half, dot, wide, high, at, near, way, apart, value], number) => {
    const text = texts[number].querySelector("text"), base = +text.getAttribute("y") / unit - top;
    if (value !== undefined) {
      for (const [name, is] of [["text-anchor", "middle"], ["x", -data.page[1] * unit]]) text.setAttribute(name, is);
      text.replaceChildren(document.createTextNode(""));
    }
    return { number, half, dot, wide, high, at, gaps: data.nears[near][0], leader: data.nears[near][1], way,
      apart, value, base, text, shell: texts[number], column: data.halves[half][0], seen: false, shown: "" };
  });

  // All places of any label, the dearest last: how far around, and the number of the distance.
  const order = [];
  for (let by = -PLACES / 2 + 1; by <= PLACES / 2; by++)
    for (let gap = 0; gap < 8; gap++) order.push([by / PLACES, gap, Math.abs(by) / 2 + gap * (gap + 3) / 2]);
  order.sort((a, b) => a[2] - b[2]);

  // The centre of a box that a way around it, at a distance, leads past 0: straight along its sides
  // and on arcs about its corners.
  function spot({ wide, high }, round, gap) {
    const arc = Math.PI / 2 * gap, quarter = wide + high + arc;
    const whole = (round - Math.floor(round)) * 4, side = Math.min(3, Math.floor(whole));
    let far = (whole - side) * quarter;
    if (side % 2) far = quarter - far;
    let x, y;
    if (far < high) [x, y] = [wide + gap, far];
    else if (far < high + arc) {
      const turn = (far - high) / gap;
      [x, y] = [wide + gap * Math.cos(turn), high + gap * Math.sin(turn)];
    } else [x, y] = [quarter - far, high + gap];
    return [side === 1 || side === 2 ? -x : x, side > 1 ? -y : y];
  }

  const around = (group, way) => {
    const p = Math.cos(way), q = Math.sin(way);
    let best = 0, most = -Infinity;
    for (let n = 0; n < PLACES; n++) {
      const [x, y] = spot(group, n / PLACES, group.gaps[0]), along = (x * p + y * q) / Math.hypot(x, y);
      if (along > most) [best, most] = [n / PLACES, along];
    }
    return best;
  };

  // Several labels as one, in rows: its size, and where in it each of them stands.
  function laid(members) {
    const rows = members.map((_, n) => n).filter((n) => n % IN_ROW === 0).map((n) => members.slice(n, n + IN_ROW));
    const widths = rows.map((row) => row.reduce((sum, each) => sum + 2 * each.wide + BETWEEN, -BETWEEN));
    const up = Math.max(...rows[0].map((each) => each.base + each.high));
    const low = Math.min(...rows.at(-1).map((each) => each.base - each.high)) - (rows.length - 1) * LEADING;
    const spots = rows.flatMap((row, number) => {
      let x = -widths[number] / 2;
      return row.map((each) => {
        x += 2 * each.wide + BETWEEN;
        return [x - BETWEEN - each.wide, each.base - number * LEADING - (up + low) / 2];
      });
    });
    return { members, spots, wide: Math.max(...widths) / 2, high: (up - low) / 2 };
  }

  function grouped(found) {
    const root = (each) => { while (each.first !== each) each = each.first; return each; }; // ends at the least number
    for (const each of found) [each.first, each.mates] = [each, null];
    for (let n = 0; n < found.length; n++)
      for (let m = 0; m < n; m++) {
        const a = found[m], b = found[n];
        if (!a.dot || !b.dot || a.column !== b.column) continue;
        const pair = a.number * all.length + b.number, away = (a.u - b.u) ** 2 + (a.v - b.v) ** 2;
        if (away < JOINED ** 2 || (away < PARTED ** 2 && joined.has(pair))) {
          joined.add(pair);
          const [one, other] = [root(a), root(b)];
          if (one.number < other.number) other.first = one;
          else one.first = other;
        } else if (joined.size) joined.delete(pair);
      }
    for (const each of found) (root(each).mates ??= []).push(each);
    return found.filter((each) => each.mates).map(({ mates: members }) => {
      const key = members.map((each) => each.number).join();
      let group = groups.get(key);
      if (!group) {
        group = { ...laid(members), half: members[0].half, column: members[0].column, dot: members[0].dot,
          gaps: members[0].gaps, leader: members[0].leader, gap: 0, clear: 2, asked: 0, key };
        const one = groups.get(`${members[0].number}`);
        group.round = one ? one.round : around(group, members[0].way);
        groups.set(key, group);
      }
      group.u = members.reduce((sum, each) => sum + each.u, 0) / members.length;
      group.v = members.reduce((sum, each) => sum + each.v, 0) / members.length;
      return group;
    });
  }

  // In each frame there are thousands of such questions: no arrays are made for them.
  const apart = (u, v, { wide, high }, p, q) => {
    const aside = Math.max(0, Math.abs(p - u) - wide), above = Math.max(0, Math.abs(q - v) - high);
    return Math.sqrt(aside * aside + above * above);
  };

  const box = (u, v, group) => ({ u, v, wide: group.wide, high: group.high, group });

  // A line from one place to another: its middle, and half its way.
  function line(a, b, c, d, half) {
    const x = (c - a) / 2, y = (d - b) / 2;
    return { u: (a + c) / 2, v: (b + d) / 2, x, y, long: Math.abs(x), tall: Math.abs(y), half };
  }

  const meets = (u, v, w, h, { u: p, v: q, x, y, long, tall, half }) => {
    const aside = u - p, above = v - q;
    return Math.abs(aside) <= w + half + long && Math.abs(above) <= h + half + tall &&
      Math.abs(aside * y - above * x) <= (w + half) * tall + (h + half) * long;
  };

  // The line from a label at a place to its dot.
  function lead(group, x, y) {
    const { u, v, wide, high } = group;
    const end = [u + x - Math.min(wide, Math.max(-wide, x)), v + y - Math.min(high, Math.max(-high, y))];
    const far = Math.hypot(end[0] - u, end[1] - v), p = (end[0] - u) / far, q = (end[1] - v) / far;
    const begin = group.gaps[0] - 0.004;
    return [u + begin * p, v + begin * q, end[0] - 0.004 * p, end[1] - 0.004 * q];
  }

  // Whether two labels are too near to one another: farther apart in a line, where they would read
  // as one.
  const near = (aside, above, wide, high) => {
    const x = Math.abs(aside) - wide, y = Math.abs(above) - high;
    return x < APART && y < APART || x < BESIDE && y < -high / 2;
  };

  // Whether a label may be at a place at all: in its room, near no other label, nearest to its dot.
  function may(group, x, y, boxes, dots, slack = 0, without = null) {
    const u = group.u + x, v = group.v + y, { wide, high } = group, room = data.halves[group.half];
    if (u - wide < room[1] || v - high < room[2] || u + wide > room[3] || v + high > room[4]) return false;
    for (const box of boxes)
      if (box.group !== without && near(u - box.u, v - box.v, wide + box.wide + slack, high + box.high + slack)) return false;
    if (!group.dot) return true;
    let own = Infinity;
    for (const each of group.members) own = Math.min(own, OWN * apart(u, v, group, each.u, each.v));
    for (const dot of dots)
      if (Math.abs(dot.u - u) < wide + own && Math.abs(dot.v - v) < high + own &&
        apart(u, v, group, dot.u, dot.v) <= own && !group.members.includes(dot)) return false;
    return true;
  }

  // How free a place is: 2 with the usual distance from strokes, 1 nearly on them, 0 not at all.
  function free(group, round, gap, { boxes, dots, lines }, slack = 0, without = null) {
    counts.candidates++;
    const [x, y] = spot(group, round, group.gaps[gap]);
    if (!may(group, x, y, boxes, dots, slack, without)) return 0;
    const u = group.u + x, v = group.v + y, { wide, high } = group, clear = CLEAR + slack;
    let found = 2;
    for (const each of lines)
      if (meets(u, v, wide + clear, high + clear, each)) {
        if (slack || meets(u, v, wide + TIGHT, high + TIGHT, each)) return 0;
        found = 1;
      }
    if (gap < group.leader) return found;
    const leader = line(...lead(group, x, y), THIN);
    return boxes.some((box) => box.group !== without && meets(box.u, box.v, box.wide, box.high, leader)) ? 0 : found;
  }

  // The best place for a label, the nearest of all that are as free, and how free it is.
  function seek(group, around, without = null) {
    let best = null;
    for (const [by, gap] of order) {
      const level = gap < group.gaps.length && free(group, group.round + by, gap, around, 0, without);
      if (level && (!best || level === 2)) best = [group.round + by, gap, level];
      if (level === 2) break;
    }
    return best;
  }

  function take(group, place) {
    [group.round, group.gap, group.clear] = place;
    return group;
  }

  // Gives a label that has no room that of another one, which then must find another place.
  function exchange(group, other, around) {
    const { boxes, lines } = around, sizes = [boxes.length, lines.length], found = seek(group, around, other);
    if (!found) return;
    const before = [group.round, group.gap, 3];
    settle(take(group, found), around);
    const next = seek(other, around, other);
    if (next) {
      boxes.splice(boxes.findIndex((box) => box.group === other), 1);
      settle(take(other, next), around);
    } else {
      [boxes.length, lines.length] = sizes;
      take(group, before);
    }
  }

  function settle(group, { boxes, lines }) {
    const [x, y] = spot(group, group.round, group.gaps[group.gap]);
    boxes.push(box(group.u + x, group.v + y, group));
    if (group.gap >= group.leader) lines.push(line(...lead(group, x, y), THIN));
  }

  // Leads a label on its way by a step, and tells where it is.
  function onWay(group, calm) {
    const far = group.gaps[group.gap];
    if (calm || !group.visible) [group.at, group.off] = [group.round, far];
    let by = group.round - group.at;
    by -= Math.round(by);
    const size = 4 * (group.wide + group.high) + 2 * Math.PI * Math.max(far, group.off);
    const length = Math.hypot(by * size, far - group.off), share = length > STEP ? STEP / length : 1;
    group.at = share < 1 ? group.at + share * by : group.round;
    group.off += share * (far - group.off);
    return share === 1;
  }

  function place(calm) {
    const columns = data.halves.map(() => ({ lines: [], boxes: [], dots: [] }));
    for (const [half, p, q, wide, high] of data.boxes)
      if (out[p] - out[p] === 0) columns[data.halves[half][0]].boxes.push(box(out[p], out[q], { wide, high }));
    for (const block of data.blocks) {
      const made = line(out[block[1]], out[block[2]], out[block[3]], out[block[4]], block[5]);
      if (made.u - made.u === 0 && made.v - made.v === 0) columns[data.halves[block[0]][0]].lines.push(made);
    }
    const found = [];
    for (const each of all) {
      each.u = out[each.at[0]];
      each.v = out[each.at[1]];
      each.there = !each.shell.classList.contains("off") && each.u - each.u === 0 && each.v - each.v === 0;
      if (vanished(out, each.apart, each.u, each.v)) each.there = false;
      if (each.there) found.push(each);
      if (each.there && each.dot) columns[each.column].dots.push(each);
    }
    const placed = grouped(found), open = [];
    let late = false;
    tick++;
    softly = !calm;
    for (const group of placed) {
      const around = columns[group.column];
      // One with a leader, which rests, now and then looks for a place without one.
      const led = group.gap >= group.leader && group.still && (calm || (tick + group.members[0].number) % SELDOM === 0);
      if (!led && free(group, group.round, group.gap, around) >= group.clear) {
        if (group.gap && group.still && free(group, group.round, group.gap - 1, around, 0.002)) group.gap--;
        settle(group, around);
      } else open.push(group);
    }
    for (const group of open) {
      // One that had no room is seldom tried again while the hand moves.
      if (group.clear === 3 && !calm && (tick + group.members[0].number) % SELDOM) continue;
      const around = columns[group.column], found = seek(group, around);
      if (found) settle(take(group, found), around);
      else group.clear = 3;
    }
    const stuck = open.filter((group) => group.clear === 3);
    for (const group of calm ? stuck : stuck.slice(tick % stuck.length).slice(0, 1)) {
      const others = placed.filter((each) => each.column === group.column && each.clear < 3 && Math.hypot(each.u - group.u, each.v - group.v) < REACH);
      if (group.tried !== group.u + group.v) [group.tried, group.first] = [group.u + group.v, group.asked];
      for (const other of calm ? others : others.slice(group.asked++ % others.length).slice(0, 1))
        if (group.clear === 3) exchange(group, other, columns[group.column]);
      late ||= group.clear < 3 || group.asked - group.first < others.length;
    }
    return show(placed, columns, calm) || late;
  }

  // Shows all labels that have a place, first those that are there; one that would jump or cross another
  // is hidden for once.
  function show(placed, columns, calm) {
    const boxes = columns.map(() => []), ready = placed.filter((group) => group.clear < 3);
    for (const group of ready) group.still = onWay(group, calm);
    for (const group of groups.values()) group.visible = false;
    hidden = placed.reduce((sum, group) => sum + group.members.length, 0);
    let moving = false;
    for (const still of [true, false]) for (const group of ready) {
      if (group.still !== still) continue;
      const [x, y] = spot(group, group.at, group.off), own = boxes[group.column];
      const jumps = !calm && group.members.some((each, n) => each.seen &&
        Math.hypot(group.u + x + group.spots[n][0] - each.u - each.off[0], group.v + y + group.spots[n][1] - each.v - each.off[1]) > JUMP);
      group.visible = !jumps && may(group, x, y, own, columns[group.column].dots);
      moving ||= !still || !group.visible;
      if (!group.visible) continue;
      own.push(box(group.u + x, group.v + y, group));
      hidden -= group.members.length;
      write(group, x, y);
    }
    for (const each of all) each.seen = false;
    for (const group of ready) if (group.visible) for (const each of group.members) each.seen = true;
    for (const each of all) if (!each.seen) put(each, "");
    return moving;
  }

  function write(group, x, y) {
    group.members.forEach((each, n) => {
      const [a, b] = group.spots[n];
      const comma = n < group.members.length - 1;
      if (comma && !each.comma) {
        each.comma = each.text.cloneNode(false);
        each.comma.style.fontStyle = "normal";
        each.comma.setAttribute("x", (each.wide - data.page[1]) * unit + 1);
        each.comma.textContent = ",";
        each.shell.append(each.comma);
      }
      if (each.comma) each.comma.style.visibility = comma ? "" : "hidden";
      let line = "";
      if (!n && group.off > group.gaps[group.leader - 1] + 1e-6)
        line = "M" + lead(group, x, y).map((value, k) => Math.round((value - (k % 2 ? group.v + y + b : group.u + x + a)) * (k % 2 ? -10 : 10) * unit) / 10).join(" ");
      each.off = [group.u + x + a - each.u, group.v + y + b - each.v];
      put(each, `translate(${pixels(group.u + x + a)}px, ${pixels(-group.v - y - b)}px)`, line);
    });
  }

  const pixels = (value) => Math.round(value * unit * 10) / 10;

  function put(each, where, line = "") {
    if (each.shown !== where) {
      counts.attributes++;
      if (!where !== !each.shown) {
        each.shell.style.visibility = where ? "" : "hidden";
        // What comes back at once was hidden for a step; what has found a place appears softly.
        if (!where) each.gone = tick;
        else if (softly && tick - each.gone > SELDOM) each.shell.animate({ opacity: [0, 1] }, 150);
      }
      if (where) each.shell.style.transform = where; // takes a twentieth less of a frame than the attribute
      each.shown = where;
    }
    if ((each.line ?? "") === line) return;
    if (!each.leads) {
      each.leads = document.createElementNS(SVG, "path");
      each.leads.setAttribute("class", data.leader);
      each.leads.setAttribute("transform", `translate(${-data.page[1] * unit} ${top * unit})`);
      each.shell.prepend(each.leads);
    }
    counts.attributes++;
    each.leads.setAttribute("d", each.line = line);
  }

  for (const each of all) each.shell.style.visibility = "hidden";
  return { place, all, groups, get hidden() { return hidden; } };
}
