// The player at the top of a report: a lit courtyard, the sky in discs, the tables' weights, all computed in the reader's
// browser. What computes weights is the ES module that the run exports, embedded to the letter and imported from a blob.

const data = JSON.parse(document.getElementById("player-data").textContent);
const $ = (name) => document.getElementById(`player-${name}`);
const DEGREE = Math.PI / 180;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, by) => a.map((value) => value * by);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const luminanceOf = (rgb) => (data.channels === 1 ? rgb[0] : dot(rgb, data.luminance));

// ---- What the page carries -----------------------------------------------------------------------------------------------

// Bytes from text, 13 bits in two letters of 91 (report/player.py), then decompressed.
async function inflate({ bytes, text }) {
  const packed = new Uint8Array(bytes), letter = (i) => {
    const code = text.charCodeAt(i);
    return code - 32 - (code > 34) - (code > 47) - (code > 60) - (code > 92);
  };
  for (let i = 0, at = 0, held = 0, bits = 0; at < bytes; i += 2) {
    held |= (91 * letter(i) + letter(i + 1)) << bits;
    for (bits += 13; bits >= 8; bits -= 8, held >>>= 8) packed[at++] = held & 255;
  }
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// The modules' texts: code, with the lines of numbers that stand behind the last one put back into their gaps.
async function moduleTexts() {
  const parts = new TextDecoder().decode(await inflate(data.modules)).split("\x02");
  const numbers = parts.pop().split("\n");
  let next = 0;
  return parts.map((code) => code.replace(/\x01/g, () => numbers[next++]));
}

// Imports a table's module once and returns it.
const modules = new Map();
function moduleOf(name) {
  if (!modules.has(name)) {
    const text = texts[data.tables.findIndex((table) => table.name === name)];
    const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    modules.set(name, import(url).finally(() => URL.revokeObjectURL(url)));
  }
  return modules.get(name);
}

// Columns of whole numbers, as report/courtyard.py packs them: differences in byte planes.
async function unpackCourtyard() {
  const raw = await inflate(data.courtyard);
  const length = new DataView(raw.buffer).getUint32(0, true);
  const facts = JSON.parse(new TextDecoder().decode(raw.subarray(4, 4 + length)));
  let start = 4 + length;
  const columns = {}, blobs = {};
  for (const { name, count, bytes } of facts.columns) {
    const values = new Int32Array(count), shift = 32 - 8 * bytes;
    for (let i = 0, sum = 0; i < count; ++i) {
      let step = 0;
      for (let plane = 0; plane < bytes; ++plane) step |= raw[start + plane * count + i] << (8 * plane);
      sum = ((sum + step) << shift) >> shift;
      values[i] = sum;
    }
    columns[name] = values;
    start += count * bytes;
  }
  for (const [name, size] of Object.entries(facts.blobs)) {
    blobs[name] = raw.slice(start, start + size);
    start += size;
  }
  return { ...facts, columns, blobs };
}

// ---- Spherical harmonics: real, orthonormal, no Condon-Shortley sign, at l(l+1)+m ---------------------------------------

const AHEAD = (l, m) => Math.sqrt((4 * l * l - 1) / (l * l - m * m));
const BEHIND = (l, m) => Math.sqrt(((l - 1) * (l - 1) - m * m) / (4 * (l - 1) * (l - 1) - 1));
const recurrences = new Map();
function recurrenceOf(bands) {
  if (!recurrences.has(bands)) {
    const steps = [];
    for (let m = 0; m < bands; ++m) {
      for (let l = m + 1; l < bands; ++l) steps.push(AHEAD(l, m), l > m + 1 ? BEHIND(l, m) : 0);
    }
    recurrences.set(bands, Float64Array.from(steps));
  }
  return recurrences.get(bands);
}

// Fills `out` from `at` on with the basis at a unit vector.
function basis([x, y, z], bands, out, at = 0) {
  const steps = recurrenceOf(bands);
  let cosine = 1, sine = 0, start = Math.sqrt(1 / (4 * Math.PI));
  for (let m = 0, step = 0; m < bands; ++m) {
    let before = 0, now = start;
    for (let l = m; l < bands; ++l) {
      const middle = at + l * (l + 1);
      out[middle + m] = now * cosine;
      if (m) out[middle - m] = now * sine;
      if (l + 1 < bands) {
        const next = steps[step] * (z * now - steps[step + 1] * before);
        before = now;
        now = next;
        step += 2;
      }
    }
    [cosine, sine] = [cosine * x - sine * y, cosine * y + sine * x];
    start *= Math.sqrt(((m ? 1 : 2) * (2 * m + 3)) / (2 * m + 2));
  }
  return out;
}

// Gauss-Legendre nodes and weights on [0, 1].
function gauss(count) {
  const nodes = [], weights = [];
  for (let i = 0; i < count; ++i) {
    let x = Math.cos((Math.PI * (i + 0.75)) / (count + 0.5)), slope = 1;
    for (let round = 0; round < 8; ++round) {
      let before = 1, now = x;
      for (let k = 2; k <= count; ++k) [before, now] = [now, ((2 * k - 1) * x * now - (k - 1) * before) / k];
      slope = (count * (x * now - before)) / (x * x - 1);
      x -= now / slope;
    }
    nodes.unshift((1 + x) / 2);
    weights.unshift(1 / ((1 - x * x) * slope * slope));
  }
  return { nodes, weights };
}

// ---- The Preetham sky, and its weights by the sun-centred rule ----------------------------------------------------------

// Returns the sky's numbers: A to E of Y, x and y, and the zenith's values over F (Preetham et al. 1999, appendix A.2).
function preetham(theta, tau) {
  const { perez, zenith } = data.formula;
  const shape = perez.map((row) => row.map(([slope, offset]) => slope * tau + offset));
  const chi = (4 / 9 - tau / 120) * (Math.PI - 2 * theta);
  const values = [1000 * ((4.0453 * tau - 4.971) * Math.tan(chi) - 0.2155 * tau + 2.4192)];
  for (const rows of zenith) {
    const cubic = rows.map(([a, b, c, d]) => ((a * theta + b) * theta + c) * theta + d);
    values.push((cubic[0] * tau + cubic[1]) * tau + cubic[2]);
  }
  const sky = { shape, theta, values };
  const above = perezOf(sky, 1, theta, Math.cos(theta));
  sky.values = values.map((value, k) => value / above[k]);
  return sky;
}

function perezOf({ shape: [a, b, c, d, e] }, height, angle, cosine) {
  const found = [0, 0, 0];
  for (let k = 0; k < 3; ++k) {
    const along = 1 + a[k] * Math.exp(b[k] / height);
    found[k] = along * (1 + c[k] * Math.exp(d[k] * angle) + e[k] * cosine * cosine);
  }
  return found;
}

// Linear RGB in cd/m2 from a height above the horizon (its sine) and an angle to the sun.
function skyRadiance(sky, height, angle, cosine = Math.cos(angle)) {
  const [fY, fx, fy] = perezOf(sky, Math.max(height, 1e-300), angle, cosine);
  const Y = sky.values[0] * fY, x = sky.values[1] * fx, y = sky.values[2] * fy;
  const X = (x / y) * Y, Z = ((1 - x - y) / y) * Y;
  return data.formula.rgb.map(([r, g, b]) => r * X + g * Y + b * Z);
}

// Gauss nodes dense towards 1: 1 - (1 - t)^power.
function graded(count, power) {
  const { nodes, weights } = gauss(count);
  const rest = [...nodes].reverse();
  return rest.map((t, i) => [1 - t ** power, weights[i] * power * t ** (power - 1)]);
}
const NODES = 40;
const CIRCLES = graded(30, 3), TURNS = graded(32, 2), ARCS = gauss(NODES);

// Weights of the sky over black ground with the sun at azimuth 0, channel by channel, and its least luminance: rings about
// the sun up to the horizon, then arcs that the horizon cuts off (quadrature/sun_centred.py).
function truth(theta, tau, bands) {
  const sky = preetham(theta, tau), count = bands * bands, out = new Float64Array(3 * count), y = new Float64Array(count);
  const sinTheta = Math.sin(theta), cosTheta = Math.cos(theta);
  function ring(g, end, weight) {
    const sinG = Math.sin(g), cosG = Math.cos(g);
    for (const [share, part] of TURNS) {
      const up = sinG * Math.cos(end * share), z = Math.max(cosTheta * cosG + sinTheta * up, 0);
      const rgb = skyRadiance(sky, z, g, cosG), both = 2 * weight * end * part;
      basis([sinTheta * cosG - cosTheta * up, sinG * Math.sin(end * share), z], bands, y);
      for (let l = 0; l < bands; ++l) {
        for (let i = l * (l + 1), last = i + l; i <= last; ++i) {
          for (let k = 0; k < 3; ++k) out[k * count + i] += both * rgb[k] * y[i];
        }
      }
    }
  }
  const reach = Math.PI / 2 - theta;
  for (const [share, part] of CIRCLES) ring(reach * share, Math.PI, reach * part * Math.sin(reach * share));
  ARCS.nodes.forEach((node, i) => {
    const u = Math.PI * (node - 0.5), h = theta * Math.sin(u);
    const cosine = h === 0 ? Math.sin(u) : Math.tan(h) / Math.tan(theta);
    ring(Math.PI / 2 + h, Math.acos(clamp(cosine, -1, 1)), Math.PI * ARCS.weights[i] * theta * Math.cos(u) * Math.cos(h));
  });
  // The least luminance lies in the plane of sun and zenith.
  let least = Infinity;
  for (let i = 1; i < 1440; ++i) {
    const angle = (i / 1440 - 0.5) * Math.PI;
    least = Math.min(least, dot(skyRadiance(sky, Math.cos(angle), Math.abs(angle - theta)), data.luminance));
  }
  return { weights: out, least };
}

// ---- The sun: its disc's radiance (light/sun_disc.py) and its place over a town -----------------------------------------

function discRadiance(theta, tau) {
  if (!data.disc || theta > Math.PI / 2) return [0, 0, 0];
  const mass = 1 / (Math.cos(theta) + 0.15 * (93.885 - theta / DEGREE) ** -1.253);
  const beta = Math.max(0.04608 * tau - 0.04586, 0), rgb = [0, 0, 0];
  for (const [r, g, b, still, aerosol, gases, vapour] of data.disc.rows) {
    const lines = (1.41 * gases * mass) / (1 + 118.93 * gases * mass) ** 0.45, wet = vapour * mass;
    const passed = Math.exp(-mass * (still + beta * aerosol) - lines - (0.2385 * wet) / (1 + 20.07 * wet) ** 0.45);
    [r, g, b].forEach((value, k) => { rgb[k] += passed * value; });
  }
  return rgb;
}

// Zenith angle and azimuth (from east towards north) of the sun, to 0.02 degrees without refraction: the low-precision
// formulas of the Astronomical Almanac. `minutes` are the local clock's, `offset` its hours ahead of UTC.
function sunOver({ latitude, longitude, date, offset }, minutes) {
  const days = Date.parse(`${date}T00:00Z`) / 864e5 - 10957.5 + (minutes - 60 * offset) / 1440;
  const anomaly = (357.528 + 0.9856003 * days) * DEGREE, mean = 280.46 + 0.9856474 * days;
  const ecliptic = (mean + 1.915 * Math.sin(anomaly) + 0.02 * Math.sin(2 * anomaly)) * DEGREE;
  const tilt = (23.439 - 4e-7 * days) * DEGREE;
  const ascension = Math.atan2(Math.cos(tilt) * Math.sin(ecliptic), Math.cos(ecliptic));
  const declination = Math.asin(Math.sin(tilt) * Math.sin(ecliptic));
  const hour = (280.46062 + 360.98564737 * days + longitude) * DEGREE - ascension, north = latitude * DEGREE;
  const east = -Math.cos(declination) * Math.sin(hour);
  const towardsNorth = Math.sin(declination) * Math.cos(north) - Math.cos(declination) * Math.sin(north) * Math.cos(hour);
  const up = Math.sin(declination) * Math.sin(north) + Math.cos(declination) * Math.cos(north) * Math.cos(hour);
  return { zenith: Math.acos(clamp(up, -1, 1)), azimuth: Math.atan2(towardsNorth, east) };
}

// ---- State --------------------------------------------------------------------------------------------------------------

const tableOf = (name) => data.tables.find((table) => table.name === name);
const sunName = data.sun;
const defaults = { table: data.best, bands: Math.min(5, tableOf(data.best).bands), view: "sun", ground: "mirror", window: "none" };
Object.assign(defaults, { difference: "bands", latitude: 43.3, longitude: 5.4, date: "2026-08-12", offset: 2, minutes: -1 });
for (const axis of document.querySelectorAll("[data-axis]")) {
  const by = axis.dataset.unit ? DEGREE : 1;
  defaults[axis.dataset.axis] = axis.dataset.axis === "turbidity" ? 3 : ((+axis.min + +axis.max) / 2) * by;
}
if (sunName) Object.assign(defaults, { [sunName]: 79 * DEGREE, sun_azimuth: 10 * DEGREE });
const state = { ...defaults };
const PATH = ["minutes", "date", "latitude", "longitude", "offset"];

function set(changes) {
  for (const [key, value] of Object.entries(changes)) {
    if (!(key in state)) throw new Error(`Invalid ${key}. Should be one of: ${Object.keys(state).join(", ")}.`);
    if (typeof defaults[key] === "number" && !Number.isFinite(+value)) throw new Error(`Invalid ${key} ${value}: no number.`);
    state[key] = typeof defaults[key] === "number" ? +value : value;
  }
  if (!tableOf(state.table)) throw new Error(`Invalid table ${state.table}.`);
  state.bands = clamp(Math.round(state.bands), 1, tableOf(state.table).bands);
  if (state.minutes >= 0 && PATH.some((key) => key in changes)) {
    const { zenith, azimuth } = sunOver(state, state.minutes);
    Object.assign(state, { [sunName]: zenith, sun_azimuth: azimuth });
  } else if (sunName in changes || "sun_azimuth" in changes) {
    state.minutes = -1;
  }
  if (sunName) {
    const [low, high] = sunRange;
    state[sunName] = clamp(state[sunName], low, high);
    state.sun_azimuth = ((state.sun_azimuth % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  }
  return refresh();
}

const fragment = () => new URLSearchParams(Object.entries(state).filter(([key, value]) => value !== defaults[key])
  .map(([key, value]) => [key, typeof value === "number" ? +value.toPrecision(7) : value])).toString();
function fromFragment() {
  const text = location.hash.slice(1);
  if (!text.includes("=")) return {};
  const told = [...new URLSearchParams(text)].map(([key, value]) => [key, typeof defaults[key] === "number" ? +value : value]);
  return Object.fromEntries(told.filter(([key, value]) => key in defaults && !Number.isNaN(value)));
}

// ---- The light of a state -----------------------------------------------------------------------------------------------

const inputsOf = (table) => table.inputs.map((name) => state[name] ?? 0);
const sunDirection = () => {
  const zenith = state[sunName], azimuth = state.sun_azimuth;
  return [Math.sin(zenith) * Math.cos(azimuth), Math.sin(zenith) * Math.sin(azimuth), Math.cos(zenith)];
};
const turbidity = () => state.turbidity ?? data.fixed.turbidity ?? 3;

// Mirrors what is black below the horizon, in place: even l + m double, odd ones vanish.
function mirror(weights, count) {
  for (let start = 0; start < weights.length; start += count) {
    for (let l = 0; l * l < count; ++l) {
      for (let m = -l; m <= l; ++m) weights[start + l * (l + 1) + m] *= (l + m) % 2 ? 0 : 2;
    }
  }
}

// The weights of one table as state asks for: over what ground, in how many bands, windowed or not.
function shaped(module, raw, table) {
  const weights = Float32Array.from(raw), { bands } = state;
  if (table.ground === "black" && state.ground === "mirror") mirror(weights, module.WEIGHTS);
  if (state.ground === "albedo" && module.applyGround) module.applyGround(weights, module.CHANNELS.map(() => 0.25));
  for (let i = 0; i < weights.length; ++i) if (i % module.WEIGHTS >= bands * bands) weights[i] = 0;
  if (state.window === "sinc" && module.applyWindow) module.applyWindow(weights, bands);
  return weights;
}

const repeated = (weights, count) => [0, 1, 2].map((k) => weights.subarray(...(data.channels === 1
  ? [0, count] : [k * count, (k + 1) * count])));

// All that is shown of a state: weights raw and shaped, the truth and errors where there is a formula, lux, exposure.
function lightNow() {
  const table = tableOf(state.table), module = loaded.get(state.table), inputs = inputsOf(table);
  const raw = module.weights(...inputs), weights = shaped(module, raw, table), count = module.WEIGHTS;
  const zonal = [0, 1, 2].slice(0, data.channels).map((k) => raw[k * count + 2] * Math.sqrt((4 * Math.PI) / 3));
  const irradiance = table.ground === "mirror" ? upperOf(raw, count) : zonal;
  const light = { table, module, inputs, raw, weights, count, bands: state.bands, skyLux: luminanceOf(irradiance) };
  light.sun = sunName && data.disc && state.view === "sun" ? discRadiance(state[sunName], turbidity()) : [0, 0, 0];
  light.sunLux = sunName && data.disc
    ? dot(discRadiance(state[sunName], turbidity()), data.luminance) * Math.PI * Math.sin(data.disc.half_angle) ** 2
      * Math.max(Math.cos(state[sunName]), 0) : 0;
  const lux = Math.max(light.skyLux + light.sunLux, 1e-6);
  // As render/tone.py exposes; relative skies, whose zenith is 1, have no adaptation.
  light.exposure = (4.9 / lux) * (lux > 100 ? lux / 50000 : 1) ** 0.16;
  if (data.formula) Object.assign(light, against(light));
  return light;
}

// A mirrored sky's irradiance on the horizontal, from its weights: half the whole sphere's |cosine|, which is nearly zonal.
function upperOf(raw, count) {
  const shares = [1 / 2, 1 / 8, -1 / 48].map((share, k) => 2 * Math.PI * share * Math.sqrt((8 * k + 2) / (8 * Math.PI)));
  const places = [0, 6, 20].filter((place) => place < count);
  return [0, 1, 2].slice(0, data.channels).map((k) => places.reduce((sum, at, i) => sum + shares[i] * raw[k * count + at], 0));
}

// The table's error against the truth of this sky (E_mean, Habel et al. 2008, eq. 3), and the sky itself.
function against(light) {
  const { count, module } = light, bands = module.BANDS, theta = state[sunName];
  const exact = truth(theta, turbidity(), bands);
  if (light.table.ground === "mirror") mirror(exact.weights, count);
  const turned = turn(exact.weights, bands, state.sun_azimuth);
  let worst = 0;
  for (let k = 0; k < 3; ++k) {
    let sum = 0;
    for (let i = 0; i < light.bands ** 2; ++i) sum += (light.raw[k * count + i] - turned[k * count + i]) ** 2;
    worst = Math.max(worst, Math.sqrt(sum));
  }
  return { truth: turned, eMean: worst / exact.least, sky: preetham(theta, turbidity()) };
}

// Turns weights about the zenith (Habel et al. 2008, eq. 4).
function turn(weights, bands, azimuth) {
  const out = Float64Array.from(weights), count = bands * bands;
  for (let start = 0; start < weights.length; start += count) {
    for (let l = 1; l < bands; ++l) {
      for (let m = 1; m <= l; ++m) {
        const plus = start + l * (l + 1) + m, minus = plus - 2 * m, c = Math.cos(m * azimuth), s = Math.sin(m * azimuth);
        out[plus] = weights[plus] * c - weights[minus] * s;
        out[minus] = weights[minus] * c + weights[plus] * s;
      }
    }
  }
  return out;
}

// Microseconds of a call: the mean over 5 ms and 64 calls at least, since clocks step by up to 0.1 ms.
function timeOf({ module, inputs }) {
  const out = module.weights(...inputs), begin = performance.now();
  let calls = 0, spent = 0;
  for (; spent < 5 || calls < 64; spent = performance.now() - begin) {
    for (let i = 0; i < 64; ++i) module.weights(...inputs, out);
    calls += 64;
  }
  return (1000 * spent) / calls;
}

// ---- Discs: the sky, its expansion, their difference --------------------------------------------------------------------

const SIDE = 144;
const shown = new Float64Array(3);

// Tone mapping as render/tone.py has it: see tone.glsl.
function display(r, g, b) {
  const luminance = 0.2126729 * r + 0.7151522 * g + 0.072175 * b, mapped = (luminance * (1 + luminance / 25)) / (1 + luminance);
  const by = luminance > 0 ? mapped / luminance : 0, hue = [Math.max(r, 0) * by, Math.max(g, 0) * by, Math.max(b, 0) * by];
  const grey = Math.min(mapped, 1), most = Math.max(...hue), room = 1 - grey;
  const share = room > 0 ? (most - grey) / room : 0, over = Math.max(share - 0.6, 0);
  const beyond = (Math.min(share, 0.6) + 0.4 * (1 - Math.exp(-over / 0.4))) * room;
  for (let k = 0; k < 3; ++k) {
    const paler = most - grey > 1e-6 ? grey + ((hue[k] - grey) * beyond) / (most - grey) : hue[k];
    const value = clamp(0.5 * (paler + (most > 0 ? (hue[k] * (grey + beyond)) / most : hue[k])), 0, 1);
    shown[k] = 255 * (value > 0.0031308 ? 1.055 * value ** (1 / 2.4) - 0.055 : 12.92 * value);
  }
  return shown;
}

// The pixels of a disc, as on a map: north up, east right, the zenith in the middle, heights evenly outwards.
const pixels = (() => {
  const found = [];
  for (let row = 0; row < SIDE; ++row) {
    for (let column = 0; column < SIDE; ++column) {
      const x = ((column + 0.5) / SIDE) * 2 - 1, y = 1 - ((row + 0.5) / SIDE) * 2, radius = Math.hypot(x, y);
      if (radius >= 1) continue;
      const flat = radius > 0 ? Math.sin((radius * Math.PI) / 2) / radius : 0;
      found.push({ place: 4 * (row * SIDE + column), along: [x * flat, y * flat, Math.cos((radius * Math.PI) / 2)] });
    }
  }
  return found;
})();
const bases = new Map();
function pixelBasis(bands) {
  if (!bases.has(bands)) {
    const values = new Float32Array(pixels.length * bands * bands);
    pixels.forEach(({ along }, i) => basis(along, bands, values, i * bands * bands));
    bases.set(bands, values);
  }
  return bases.get(bands);
}

// Radiance of all pixels by weights, three numbers each.
function expanded(weights, module, bands) {
  const values = pixelBasis(module.BANDS), count = module.WEIGHTS, used = bands * bands, out = new Float32Array(3 * pixels.length);
  const channels = repeated(weights, count);
  for (let i = 0; i < pixels.length; ++i) {
    for (let k = 0; k < 3; ++k) {
      let sum = 0;
      for (let j = 0; j < used; ++j) sum += channels[k][j] * values[i * count + j];
      out[3 * i + k] = sum;
    }
  }
  return out;
}

const BLUE = [33, 102, 172], RED = [178, 24, 43];
function diverging(share, image, place) {
  const to = share < 0 ? BLUE : RED, by = Math.min(Math.abs(share), 1);
  for (let k = 0; k < 3; ++k) image[place + k] = 247 + (to[k] - 247) * by;
}

function paint(canvas, colourOf) {
  const context = canvas.getContext("2d"), image = context.createImageData(SIDE, SIDE);
  pixels.forEach(({ place }, i) => {
    colourOf(i, image.data, place);
    image.data[place + 3] = 255;
  });
  context.putImageData(image, 0, 0);
  if (!sunName) return;
  const radius = state[sunName] / (Math.PI / 2), middle = SIDE / 2;
  context.beginPath();
  context.arc(middle * (1 + radius * Math.cos(state.sun_azimuth)), middle * (1 - radius * Math.sin(state.sun_azimuth)), 4, 0, 7);
  context.lineWidth = 3;
  context.strokeStyle = "#000";
  context.stroke();
  context.lineWidth = 1.5;
  context.strokeStyle = "#fff";
  context.stroke();
}

const nice = (value) => {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].find((step) => value <= step * power * 1.0001) * power;
};
const percent = (value) => `${Number((100 * value).toPrecision(2)).toLocaleString("en", { maximumSignificantDigits: 2 })} %`;

function paintDiscs(light) {
  const { module, bands, exposure } = light, plain = state.difference === "table" && light.truth;
  const few = expanded(light.weights, module, bands);
  const sky = light.sky ? exactSky(light) : expanded(light.raw, module, module.BANDS);
  // Of the table's own error both are expansions in the same bands, over the ground that the table has.
  const one = plain ? expanded(light.raw, module, bands) : few, other = plain ? expanded(light.truth, module, bands) : sky;
  const by = (of) => (i, image, place) => image.set(display(...of.subarray(3 * i, 3 * i + 3).map((v) => v * exposure)), place);
  paint($("sky"), by(sky));
  paint($("few"), by(few));
  const differences = pixels.map((_, i) => luminanceOf(one.subarray(3 * i)) - luminanceOf(other.subarray(3 * i)));
  let mean = 0, weight = 0;
  pixels.forEach(({ along: [, , z] }, i) => { mean += luminanceOf(sky.subarray(3 * i)); weight += 1; });
  mean /= weight;
  const sorted = differences.map((value) => Math.abs(value) / mean).sort((a, b) => a - b);
  const scale = plain ? nice(Math.max(sorted[sorted.length - 1], 1e-9)) : nice(Math.max(sorted[Math.floor(0.98 * sorted.length)], 1e-6));
  paint($("difference"), (i, image, place) => diverging(differences[i] / mean / scale, image, place));
  const spread = percent(scale);
  $("low").textContent = `−${spread}`;
  $("high").textContent = `+${spread}`;
  $("few-name").textContent = `${bands} band${bands > 1 ? "s" : ""} of the table`;
  light.scale = scale;
}

function exactSky({ sky }) {
  const out = new Float32Array(3 * pixels.length), sun = sunDirection();
  pixels.forEach(({ along }, i) => {
    const cosine = clamp(dot(along, sun), -1, 1);
    out.set(skyRadiance(sky, along[2], Math.acos(cosine), cosine), 3 * i);
  });
  return out;
}

// ---- The courtyard ------------------------------------------------------------------------------------------------------

const SHADOW_SIDE = 2048;
const COSINE_LOBE = [1, 2 / 3, 1 / 4, 0, -1 / 24, 0, 1 / 64];   // of each degree: irradiance / pi of a surface that nothing shades

async function makeScene() {
  const canvas = $("canvas");
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) return null;
  const about = gl.getExtension("WEBGL_debug_renderer_info");
  if (about && /swiftshader|llvmpipe|software|basic render/i.test(gl.getParameter(about.UNMASKED_RENDERER_WEBGL))) most = 640 * 360;
  const court = await unpackCourtyard(), { columns, units, bands } = court;
  const seen = columns.colour.length, fours = Math.ceil(court.components / 4), count = bands * bands;
  const woven = (names, by, Kind = Float32Array, wide = names.length, many = seen) => {
    const out = new Kind(wide * many);
    names.forEach((name, k) => { for (let i = 0; i < many; ++i) out[wide * i + k] = columns[name][i] * by; });
    return out;
  };
  const positions = woven(["x", "y", "z"], units.position, Float32Array, 3, columns.x.length);
  const normals = woven(["normal_x", "normal_y", "normal_z"], units.normal);
  const four = (k) => [0, 1, 2, 3].map((i) => `component_${4 * k + i}`).filter((name) => name in columns);
  const buffer = gl.createBuffer();
  const attributes = [
    [0, 3, positions], [1, 3, normals], [2, 2, woven(["u", "v"], units.uv)], [3, 2, woven(["colour", "material"], 1)],
    [4, 3, new Float32Array(3 * seen), buffer], ...Array.from({ length: fours }, (_, k) => [5 + k, 4, woven(four(k), 1, Int8Array, 4)]),
  ];
  const lit = meshOf(gl, attributes, columns.seen), casting = meshOf(gl, attributes.slice(0, 1), [...columns.seen, ...columns.hidden]);
  const define = `#define SHADOW_SIDE ${SHADOW_SIDE}.0\n#define BANDS ${bands}\n#define WEIGHTS ${count}\n`;
  const [scene, sky, shadow] = ["scene", "sky", "shadow"].map((name) => programOf(gl, name, define));
  const map = makeShadowMap(gl), camera = cameraOf(court.camera);
  const matrix = Float64Array.from(columns.matrix, (value, i) => value * court.scales[Math.floor(i / (4 * count))]);
  let open = null, last = "", towards = null;
  await makeTextures(gl, court.blobs);

  // Fills the vertices' light where nothing shades, for that view alone.
  function fillOpen(weights) {
    if (!open) {
      open = new Float32Array(seen * count);
      for (let i = 0; i < seen; ++i) basis(unit([...normals.subarray(3 * i, 3 * i + 3)]), bands, open, i * count);
    }
    const values = new Float32Array(3 * seen), lobe = Array.from({ length: count }, (_, i) => COSINE_LOBE[Math.floor(Math.sqrt(i))]);
    for (let i = 0; i < seen; ++i) {
      for (let k = 0; k < 3; ++k) {
        for (let j = 0; j < weights[k].length; ++j) values[3 * i + k] += lobe[j] * weights[k][j] * open[i * count + j];
      }
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, values);
  }

  // A frame's uniforms: what compression.uniforms makes of the light, of direct light alone where nothing bounces.
  function uniformsOf(weights, sun, bounces) {
    const out = new Float32Array(3 * (4 * fours + 1)), rows = matrix.length / (4 * count);
    for (let row = 0; row < rows; ++row) {
      for (let k = 0; k < 3; ++k) {
        const start = row * 4 * count, bounced = start + (1 + k) * count;
        for (let i = 0; i < Math.min(weights[k].length, count); ++i) {
          out[3 * row + k] += matrix[start + i] * weights[k][i];
          if (bounces) out[3 * row + k] += matrix[bounced + i] * (weights[k][i] + sun[k][i]);
        }
      }
    }
    return out;
  }

  function drawShadows(sun) {
    if (last === String(sun)) return;
    last = String(sun);
    towards = towardsSun(positions, sun);
    gl.bindFramebuffer(gl.FRAMEBUFFER, map);
    gl.viewport(0, 0, SHADOW_SIDE, SHADOW_SIDE);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.useProgram(shadow.program);
    gl.uniformMatrix4fv(shadow.at("towardsSun"), false, towards.matrix);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1.5, 4);
    casting.draw();
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  function draw(light) {
    const direction = sunDirection(), used = Math.min(light.count, count), shining = light.sun.some((value) => value > 0);
    const weights = repeated(light.weights, light.count).map((one) => one.subarray(0, used));
    const aim = basis(direction, bands, new Float64Array(count)).map((value, i) => (i < light.bands ** 2 ? value : 0));
    const disc = data.disc ? data.disc.half_angle : 0, aspect = canvas.width / canvas.height;
    const sun = light.sun.map((value) => aim.map((one) => one * value * 2 * Math.PI * (1 - Math.cos(disc))));
    if (shining || !towards) drawShadows(direction);
    if (state.view === "open") fillOpen(weights);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.useProgram(scene.program);
    gl.uniformMatrix4fv(scene.at("camera"), false, camera.matrix(aspect));
    gl.uniformMatrix4fv(scene.at("towardsSun"), false, towards.matrix);
    gl.uniform3fv(scene.at("light"), uniformsOf(weights, sun, state.view === "sun" || state.view === "bounces"));
    gl.uniform3fv(scene.at("palette"), court.palette.flat());
    gl.uniform1f(scene.at("open"), state.view === "open" ? 1 : 0);
    gl.uniform1f(scene.at("texel"), towards.texel);
    gl.uniform3fv(scene.at("sun"), direction);
    gl.uniform3fv(scene.at("sunlight"), scaled(light.sun, Math.sin(disc) ** 2));
    gl.uniform2fv(scene.at("rings"), court.rings.edges);
    gl.uniform3fv(scene.at("ringColour"), court.rings.colour);
    gl.uniform1f(scene.at("exposure"), light.exposure);
    ["paving", "painted", "shadows"].forEach((name, k) => gl.uniform1i(scene.at(name), k));
    lit.draw();
    gl.useProgram(sky.program);
    Object.entries(camera.frame(aspect)).forEach(([name, value]) => gl.uniform3fv(sky.at(name), value));
    gl.uniform3fv(sky.at("sun"), direction);
    gl.uniform3fv(sky.at("disc"), light.sun);
    gl.uniform1f(sky.at("halfAngle"), shining ? disc : 0);
    gl.uniform1f(sky.at("exposure"), light.exposure);
    gl.uniform1i(sky.at("exact"), light.sky ? 1 : 0);
    if (light.sky) {
      gl.uniform3fv(sky.at("zenith"), light.sky.values);
      gl.uniform3fv(sky.at("perez"), light.sky.shape.flat());
      gl.uniformMatrix3fv(sky.at("toRgb"), true, data.formula.rgb.flat());
    } else {
      const plain = repeated(light.raw, light.count);
      gl.uniform3fv(sky.at("weights"), Array.from({ length: 3 * count }, (_, i) => plain[i % 3][Math.floor(i / 3)] ?? 0));
    }
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  return { canvas, draw, finish: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)) };
}

// Vertices of attributes, [place, size, values, buffer]: bytes count as numbers from -1 to 1.
function meshOf(gl, attributes, indices) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  for (const [place, size, values, buffer = gl.createBuffer()] of attributes) {
    const bytes = values instanceof Int8Array;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, bytes ? gl.BYTE : gl.FLOAT, bytes, 0, 0);
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint16Array.from(indices), gl.STATIC_DRAW);
  const draw = () => {
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_SHORT, 0);
  };
  return { draw };
}

function programOf(gl, name, define) {
  const program = gl.createProgram();
  for (const [end, kind] of [["vert", gl.VERTEX_SHADER], ["frag", gl.FRAGMENT_SHADER]]) {
    const shader = gl.createShader(kind), tone = end === "frag" ? data.shaders["tone.frag"] : "";
    gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${define}${tone}${data.shaders[`${name}.${end}`]}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  const log = () => gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader)).join("\n");
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`Shader ${name}: ${gl.getProgramInfoLog(program)} ${log()}`);
  const places = new Map();
  const at = (uniform) => {
    if (!places.has(uniform)) places.set(uniform, gl.getUniformLocation(program, uniform));
    return places.get(uniform);
  };
  return { program, at };
}

// A depth texture that compares and interpolates, on unit 2.
function makeShadowMap(gl) {
  const frame = gl.createFramebuffer(), texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW_SIDE, SHADOW_SIDE);
  const settings = { COMPARE_MODE: "COMPARE_REF_TO_TEXTURE", MIN_FILTER: "LINEAR", MAG_FILTER: "LINEAR", WRAP_S: "CLAMP_TO_EDGE" };
  for (const [name, value] of Object.entries({ ...settings, WRAP_T: "CLAMP_TO_EDGE" })) {
    gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
  }
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
  gl.drawBuffers([gl.NONE]);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return frame;
}

// The paving on unit 0; what is painted with one small texture each, layer by layer, on unit 1.
async function makeTextures(gl, { paving, ...others }) {
  const picture = (bytes, more) => createImageBitmap(new Blob([bytes], { type: "image/webp" }),
    { colorSpaceConversion: "none", imageOrientation: "flipY", ...more });
  const side = 512, small = { resizeWidth: side, resizeHeight: side, resizeQuality: "pixelated" };
  const [floor, ...layers] = await Promise.all([picture(paving), ...Object.values(others).map((one) => picture(one, small))]);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, floor);
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 10, gl.SRGB8_ALPHA8, side, side, layers.length);
  layers.forEach((one, k) => gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, side, side, 1, gl.RGBA, gl.UNSIGNED_BYTE, one));
  const sharper = gl.getExtension("EXT_texture_filter_anisotropic");
  [gl.TEXTURE_2D, gl.TEXTURE_2D_ARRAY].forEach((target, k) => {
    gl.activeTexture(gl.TEXTURE0 + k);
    gl.generateMipmap(target);
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    if (sharper && !k) gl.texParameterf(target, sharper.TEXTURE_MAX_ANISOTROPY_EXT, 4);
  });
}

// A pinhole camera as render/camera.py has it; matrices column by column.
function cameraOf({ eye, target, field }) {
  const ahead = unit(target.map((value, i) => value - eye[i])), right = unit([ahead[1], -ahead[0], 0]);
  const up = cross(right, ahead), reach = Math.tan((field * DEGREE) / 2), near = 0.3, far = 800;
  const matrix = (aspect) => {
    const rows = [scaled(right, 1 / (reach * aspect)), scaled(up, 1 / reach), scaled(ahead, (far + near) / (far - near)), ahead];
    const moved = rows.map((row, k) => -dot(row, eye) - (k === 2 ? (2 * far * near) / (far - near) : 0));
    return [0, 1, 2].flatMap((k) => rows.map((row) => row[k])).concat(moved);
  };
  const frame = (aspect) => ({ ahead, across: scaled(right, reach * aspect), upward: scaled(up, reach) });
  return { matrix, frame };
}

// Parallel light's view of all that is near, as tight as it goes, and how wide one of its texels is in metres.
function towardsSun(positions, sun) {
  const side = Math.hypot(sun[0], sun[1]) > 1e-6 ? unit([-sun[1], sun[0], 0]) : [0, 1, 0], up = cross(sun, side);
  const rows = [side, up, scaled(sun, -1)], low = [1e9, 1e9, 1e9], high = [-1e9, -1e9, -1e9];
  for (let i = 0; i < positions.length; i += 3) {
    const point = positions.subarray(i, i + 3);
    if (Math.abs(point[0]) > 20 || Math.abs(point[1]) > 20) continue;
    rows.forEach((row, k) => {
      const value = dot(row, point);
      if (value < low[k]) low[k] = value;
      if (value > high[k]) high[k] = value;
    });
  }
  const by = rows.map((_, k) => 2 / (high[k] - low[k] + 0.2)), middle = rows.map((_, k) => (high[k] + low[k]) / 2);
  const matrix = [0, 1, 2].flatMap((k) => [...rows.map((row, i) => row[k] * by[i]), 0]);
  return { matrix: [...matrix, ...middle.map((value, i) => -value * by[i]), 1], texel: 2 / Math.min(by[0], by[1]) / SHADOW_SIDE };
}

// ---- What the reader sees and moves -------------------------------------------------------------------------------------

const loaded = new Map();
let texts = [], scene = null, current = null, playing = 0, waiting = null;
const sunSlider = document.querySelector(`#player [data-key="height"]`);
const sunRange = sunSlider ? [(90 - sunSlider.max) * DEGREE, (90 - sunSlider.min) * DEGREE] : [0, 0];
const number = (value, digits = 3) => Number(value.toPrecision(digits)).toLocaleString("en");
const clock = (minutes) => `${String(Math.floor(minutes / 60)).padStart(2, "0")}:${String(Math.round(minutes) % 60).padStart(2, "0")}`;
const say = (name, text) => { if ($(name)) $(name).textContent = text; };

// Gathers changes and shows them with the next picture: pointers tell more often than that.
function soon(changes) {
  if (!waiting) requestAnimationFrame(() => { const all = waiting; waiting = null; set(all); });
  waiting = { ...waiting, ...changes };
}

function refresh() {
  current = lightNow();
  if (scene) {
    fit(scene.canvas);
    scene.draw(current);
  }
  paintDiscs(current);
  tell(current);
  const text = fragment();
  if (text || location.hash.includes("=")) history.replaceState(null, "", `#${text || "="}`);
  return { ...state };
}

// As many pixels as the screen has for it, but no more than a machine without a graphics card draws in a tenth of a second.
let most = 1600 * 900;
function fit(canvas) {
  const box = canvas.parentElement.getBoundingClientRect(), density = window.devicePixelRatio || 1;
  const by = Math.min(density, Math.sqrt(most / Math.max(box.width * box.height, 1)));
  const [width, height] = [box.width, box.height].map((value) => Math.max(Math.round(value * by), 1));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
}

function tell(light) {
  const { table } = light;
  if (sunName) {
    const height = 90 - state[sunName] / DEGREE;
    say("when", `${state.minutes >= 0 ? `${clock(state.minutes)}, ` : ""}sun ${number(height)}° high, ${compass(state.sun_azimuth)}`);
  }
  say("lux", data.disc ? `${number(light.skyLux / 1000)} klx of sky, ${number(light.sunLux / 1000)} of sun` : `${number(light.skyLux)}`);
  say("bytes", `${table.bytes.toLocaleString("en")} bytes`);
  say("error", light.eMean === undefined ? `at most ${percent(table.e_mean)}` : percent(light.eMean));
  say("time", light.table.microseconds ? `${number(light.table.microseconds, 2)} µs` : "…");
  for (const control of document.querySelectorAll("#player [data-key]")) showIn(control);
  if (!table.microseconds) {
    setTimeout(() => { table.microseconds ??= timeOf(light); say("time", `${number(tableOf(state.table).microseconds ?? 0, 2)} µs`); }, 30);
  }
  if ($("engine").open) say("code", codeFor($("format").value));
}

const compass = (azimuth) => ["E", "NE", "N", "NW", "W", "SW", "S", "SE"][Math.round(azimuth / (Math.PI / 4)) % 8];

// What a control shows of the state, and what it sets: the sun by height and azimuth in degrees, angles in degrees.
function valueOf(key, control) {
  if (key === "height") return 90 - state[sunName] / DEGREE;
  return control.dataset.unit ? state[key] / DEGREE : state[key];
}
function changeOf(key, control) {
  if (key === "height") return { [sunName]: (90 - control.value) * DEGREE };
  return { [key]: control.dataset.unit ? control.value * DEGREE : control.value };
}

function showIn(control) {
  const { key } = control.dataset, value = valueOf(key, control);
  if (control.type === "radio") control.checked = control.value === value;
  else if (control !== document.activeElement || control.type === "range") {
    if (key === "minutes" && value < 0) return;
    control.value = control.type === "range" || control.type === "number" ? +(+value).toFixed(4) : value;
  }
  if (key === "bands") control.max = tableOf(state.table).bands;
  const output = control.parentElement.querySelector(".value");
  if (output) output.textContent = key === "minutes" ? clock(+control.value) : `${number(+value)}${control.dataset.unit ?? ""}`;
}

// The minutes of the day's first and last light at the place, and of its highest sun.
function day() {
  const minutes = Array.from({ length: 289 }, (_, k) => 5 * k), up = minutes.filter((one) => sunOver(state, one).zenith < 89.5 * DEGREE);
  const noon = minutes.reduce((best, one) => (sunOver(state, one).zenith < sunOver(state, best).zenith ? one : best), 0);
  return { first: up[0] ?? 0, last: up[up.length - 1] ?? 1440, noon };
}

function showDay() {
  const slider = document.querySelector(`#player [data-key="minutes"]`);
  if (!slider) return;
  const { first, last } = day();
  Object.assign(slider, { min: first, max: last });
}

const PRESETS = {
  morning: () => ({ [sunName]: 79 * DEGREE, sun_azimuth: 10 * DEGREE, turbidity: 3 }),
  noon: () => ({ turbidity: 3, minutes: day().noon }),
  sunset: () => ({ [sunName]: 86 * DEGREE, sun_azimuth: 230 * DEGREE, turbidity: 3.5 }),
  hazy: () => ({ [sunName]: 66 * DEGREE, sun_azimuth: -35 * DEGREE, turbidity: 6 }),
};
const known = (changes) => Object.fromEntries(Object.entries(changes).filter(([key]) => key in state));

function play() {
  cancelAnimationFrame(playing);
  if (playing) playing = 0;
  else step();
  $("play").textContent = playing ? "Pause" : "Play the day";
  function step() {
    const { first, last } = day(), next = state.minutes < first || state.minutes >= last ? first : state.minutes + 2;
    set({ minutes: next });
    playing = requestAnimationFrame(step);
  }
}

// What an engine's programmer wants of this light.
function codeFor(format) {
  const { table, module, weights, count, inputs, bands } = current;
  const named = module.CHANNELS, by = (k) => [...weights.subarray(k * count, k * count + bands * bands)];
  const shaping = `${bands} bands, ground: ${state.ground}, window: ${state.window}`;
  const float = (value) => { const text = String(Math.fround(value) === value ? +value.toPrecision(9) : +value.toPrecision(7)); return /[.e]/.test(text) ? text : `${text}.0`; };
  if (format === "c") {
    const upper = table.prefix.toUpperCase();
    return `#include "skylight_sh.h" /* ${table.name}, ${table.bytes} bytes */\n\nfloat w[${upper}_CHANNELS][${upper}_WEIGHTS];\n`
      + `int status = ${table.prefix}_weights(${inputs.map((value) => `${float(value)}f`).join(", ")}, w); /* ${table.inputs.join(", ")} */\n`;
  }
  if (format === "json") {
    const about = { table: table.name, inputs: Object.fromEntries(table.inputs.map((name, i) => [name, inputs[i]])) };
    return JSON.stringify({ ...about, bands, ground: state.ground, window: state.window, unit: module.UNIT,
      weights: Object.fromEntries(named.map((name, k) => [name, by(k).map((value) => +value.toPrecision(7))])) }, null, 1);
  }
  if (format === "glsl") {
    const rows = Array.from({ length: bands * bands }, (_, i) => `  vec3(${[0, 1, 2].map((k) => float(repeated(weights, count)[k][i])).join(", ")})`);
    return `// ${table.name}, ${module.UNIT}; ${shaping}. Real orthonormal SH, no Condon-Shortley sign, l*(l+1)+m, +z up.\n`
      + `const vec3 sky[${rows.length}] = vec3[](\n${rows.join(",\n")}\n);\n`;
  }
  return `import skylight_sh\n\nsky = skylight_sh.load("skylight_sh.npz")  # ${table.name}\nw = sky.weights(${inputs.map(float).join(", ")})\n`;
}

async function copy() {
  const text = codeFor($("format").value);
  const done = await navigator.clipboard.writeText(text).then(() => true, () => false);
  if (!done) getSelection().selectAllChildren($("code"));
  say("copied", done ? "Copied." : "Selected: press Ctrl+C.");
}

// ---- Pointers and keys --------------------------------------------------------------------------------------------------

function steer(element, place) {
  let from = null;
  element.addEventListener("pointerdown", (event) => {
    from = { x: event.clientX, y: event.clientY, zenith: state[sunName], azimuth: state.sun_azimuth };
    element.setPointerCapture(event.pointerId);
    $("hint")?.classList.add("gone");
    if (place) soon(place(event));
  });
  element.addEventListener("pointermove", (event) => {
    if (!from || !(event.buttons & 1)) return;
    const turned = { [sunName]: from.zenith + (event.clientY - from.y) * 0.2 * DEGREE, sun_azimuth: from.azimuth + (event.clientX - from.x) * -0.35 * DEGREE };
    soon(place ? place(event) : turned);
  });
  for (const name of ["pointerup", "pointercancel"]) element.addEventListener(name, () => { from = null; });
}

function inDisc(event) {
  const box = event.target.getBoundingClientRect();
  const x = ((event.clientX - box.left) / box.width) * 2 - 1, y = 1 - ((event.clientY - box.top) / box.height) * 2;
  return { [sunName]: Math.min(Math.hypot(x, y), 1) * (Math.PI / 2), sun_azimuth: Math.atan2(y, x) };
}

function press(event) {
  const by = (event.shiftKey ? 5 : 1) * DEGREE, { target } = event;
  const moves = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1] }[event.key];
  if (event.ctrlKey || event.metaKey || event.altKey || /^(input|select|textarea|button|summary)$/i.test(target.tagName)) return;
  if (moves && sunName && target.closest(".stage, .discs")) {
    set({ [sunName]: state[sunName] + moves[0] * by, sun_azimuth: state.sun_azimuth + moves[1] * by });
  } else if (/^[1-7]$/.test(event.key)) set({ bands: +event.key });
  else if (event.key === " " && $("play") && target.closest(".stage, .discs")) play();
  else return;
  event.preventDefault();
}

function listen() {
  for (const control of document.querySelectorAll("#player [data-key]")) {
    control.addEventListener("input", () => {
      if (control.value === "" || (control.type === "radio" && !control.checked)) return;
      soon(changeOf(control.dataset.key, control));
      if (PATH.includes(control.dataset.key)) requestAnimationFrame(showDay);
    });
  }
  for (const button of document.querySelectorAll("#player [data-preset]")) {
    button.addEventListener("click", () => set(known(PRESETS[button.dataset.preset]())));
  }
  $("play")?.addEventListener("click", play);
  $("copy").addEventListener("click", copy);
  for (const name of ["engine", "format"]) $(name).addEventListener(name === "engine" ? "toggle" : "input", () => say("code", codeFor($("format").value)));
  if (sunName && "sun_azimuth" in state) {
    if (scene) steer($("stage"));
    for (const name of ["sky", "few", "difference"]) steer($(name), inDisc);
  }
  document.addEventListener("keydown", press);
  addEventListener("hashchange", () => { if (location.hash.includes("=")) set({ ...defaults, ...fromFragment() }); });
  new ResizeObserver(() => { if (scene && current) { fit(scene.canvas); scene.draw(current); } }).observe($("stage") ?? $("sky"));
}

async function start() {
  texts = await moduleTexts();
  Object.assign(state, fromFragment());
  if (!tableOf(state.table)) state.table = defaults.table;
  loaded.set(state.table, await moduleOf(state.table));
  scene = data.courtyard ? await makeScene() : null;
  set({ bands: state.bands });
  if (scene) {
    scene.finish();
    $("stage").classList.add("drawn");
  }
  for (const { name } of data.tables) loaded.set(name, await moduleOf(name));
  showDay();
  listen();
}

window.skylight = {
  ready: start(),
  tables: data.tables.map(({ name }) => name),
  weights: (table, ...inputs) => {
    if (!loaded.has(table)) throw new Error(`Invalid table ${table}. Should be one of: ${[...loaded.keys()].join(", ")}.`);
    return loaded.get(table).weights(...inputs.slice(0, tableOf(table).inputs.length));
  },
  set,
  state: () => ({ ...state }),
  errors: () => ({
    e_mean: current.eMean ?? null, measured: current.table.e_mean, difference: current.scale,
    microseconds: current.table.microseconds ?? null, sky_lux: current.skyLux, sun_lux: current.sunLux,
  }),
};
