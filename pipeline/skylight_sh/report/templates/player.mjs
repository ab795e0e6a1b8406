// The player at the top of a report: a lit courtyard, the sky in discs and the tables' weights, all computed in the reader's
// browser. What computes weights is the ES module that the run exports, embedded to the letter and imported from a blob.

const data = JSON.parse(document.getElementById("player-data").textContent);
const $ = (name) => document.getElementById(`player-${name}`);
const controls = [...document.querySelectorAll("#player [data-key]")];
const DEGREE = Math.PI / 180, RIGHT = Math.PI / 2;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, by) => a.map((value) => value * by);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const luminanceOf = (rgb, at = 0) => data.luminance.reduce((sum, share, k) => sum + share * rgb[at + k], 0);

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
  const parts = new TextDecoder().decode(await inflate(data.modules)).split("\x02"), numbers = parts.pop().split("\n");
  let next = 0;
  return parts.map((code) => code.replace(/\x01/g, () => numbers[next++]));
}

const tableOf = (name) => data.tables.find((table) => table.name === name);
const loaded = new Map();
async function load(name, texts) {
  if (loaded.has(name)) return;
  const url = URL.createObjectURL(new Blob([texts[data.tables.indexOf(tableOf(name))]], { type: "text/javascript" }));
  loaded.set(name, await import(url));
  URL.revokeObjectURL(url);
}

// Columns of whole numbers, as report/courtyard.py packs them: differences in byte planes; then pictures.
async function unpackCourtyard() {
  const raw = await inflate(data.courtyard), length = new DataView(raw.buffer).getUint32(0, true);
  const facts = JSON.parse(new TextDecoder().decode(raw.subarray(4, 4 + length))), columns = {}, blobs = {};
  let start = 4 + length;
  for (const { name, count, bytes } of facts.columns) {
    const values = new Int32Array(count), shift = 32 - 8 * bytes;
    for (let i = 0, sum = 0; i < count; ++i) {
      for (let plane = 0; plane < bytes; ++plane) sum += raw[start + plane * count + i] << (8 * plane);
      sum = (sum << shift) >> shift;
      values[i] = sum;
    }
    columns[name] = values;
    start += count * bytes;
  }
  for (const [name, size] of Object.entries(facts.blobs)) blobs[name] = raw.slice(start, (start += size));
  return { ...facts, columns, blobs };
}

// ---- Spherical harmonics: real, orthonormal, without the Condon-Shortley sign, at l(l+1)+m -------------------------------
// Fills `out` from `at` on with the basis at a unit vector, by the recurrence in the degree (formula/harmonics.py).
function basis(x, y, z, bands, out, at = 0) {
  for (let m = 0, cosine = 1, sine = 0; m < bands; ++m) {
    const { start, steps } = data.legendre[m];
    for (let l = m, before = 0, now = start; l < bands; ++l) {
      const middle = at + l * (l + 1);
      out[middle + m] = now * cosine;
      if (m) out[middle - m] = now * sine;
      if (l + 1 < bands) [before, now] = [now, steps[l - m][0] * z * now - steps[l - m][1] * before];
    }
    [cosine, sine] = [cosine * x - sine * y, cosine * y + sine * x];
  }
  return out;
}

// Turns weights about the zenith (Habel et al. 2008, eq. 4).
function turned(weights, count, azimuth) {
  const out = Float64Array.from(weights);
  for (let start = 0; start < weights.length; start += count) {
    for (let l = 1; l * l < count; ++l) {
      for (let m = 1; m <= l; ++m) {
        const plus = start + l * (l + 1) + m, minus = plus - 2 * m, c = Math.cos(m * azimuth), s = Math.sin(m * azimuth);
        out[plus] = weights[plus] * c - weights[minus] * s;
        out[minus] = weights[minus] * c + weights[plus] * s;
      }
    }
  }
  return out;
}

// Mirrors what is black below the horizon, in place: weights of even l + m double, the others vanish.
function mirror(weights, count) {
  weights.forEach((value, i) => { weights[i] = (i % count - Math.floor(Math.sqrt(i % count)) ** 2) % 2 ? 0 : 2 * value; });
}

// ---- The Preetham sky, and its weights by the sun-centred rule -----------------------------------------------------------
// The sky's numbers: A to E of Y, x and y, and the zenith's values over F (Preetham et al. 1999, appendix A.2).
function preetham(theta, tau) {
  const { perez, zenith } = data.formula, chi = (4 / 9 - tau / 120) * (Math.PI - 2 * theta);
  const values = [1000 * ((4.0453 * tau - 4.971) * Math.tan(chi) - 0.2155 * tau + 2.4192)];
  for (const rows of zenith) {
    const cubic = rows.map(([a, b, c, d]) => ((a * theta + b) * theta + c) * theta + d);
    values.push((cubic[0] * tau + cubic[1]) * tau + cubic[2]);
  }
  const sky = { shape: perez.map((row) => row.map(([slope, offset]) => slope * tau + offset)) };
  const above = [0, 1, 2].map((k) => perezOf(sky.shape, k, 1, theta, Math.cos(theta)));
  return { ...sky, values: values.map((value, k) => value / above[k]) };
}

function perezOf([a, b, c, d, e], k, height, angle, cosine) {
  return (1 + a[k] * Math.exp(b[k] / height)) * (1 + c[k] * Math.exp(d[k] * angle) + e[k] * cosine * cosine);
}

// Linear RGB in cd/m2 at a height above the horizon (its sine) and an angle to the sun.
function radianceOf({ shape, values }, height, angle, cosine) {
  const [Y, x, y] = values.map((value, k) => value * perezOf(shape, k, Math.max(height, 1e-300), angle, cosine));
  return data.formula.rgb.map((row) => ((row[0] * x + row[1] * y + row[2] * (1 - x - y)) * Y) / y);
}

// Weights of the sky over black ground, the sun at azimuth 0, channel by channel, and its least luminance: rings about the
// sun up to the horizon, then arcs that the horizon cuts off (quadrature/sun_centred.py).
function truth(theta, tau, bands) {
  const sky = preetham(theta, tau), { circles, arcs, turns } = data.formula.rule, count = bands * bands;
  const out = new Float64Array(3 * count), y = new Float64Array(count);
  const sinTheta = Math.sin(theta), cosTheta = Math.cos(theta);
  function ring(angle, end, weight) {
    const sine = Math.sin(angle), cosine = Math.cos(angle);
    for (const [share, part] of turns) {
      const up = sine * Math.cos(end * share), z = Math.max(cosTheta * cosine + sinTheta * up, 0);
      const rgb = radianceOf(sky, z, angle, cosine), both = 2 * weight * end * part;
      basis(sinTheta * cosine - cosTheta * up, sine * Math.sin(end * share), z, bands, y);
      for (let k = 0; k < 3; ++k) for (let i = 0; i < count; ++i) out[k * count + i] += both * rgb[k] * y[i];
    }
  }
  const reach = RIGHT - theta;
  for (const [share, part] of circles) ring(reach * share, Math.PI, reach * part * Math.sin(reach * share));
  for (const [u, part] of arcs) {
    const h = theta * Math.sin(u), cosine = h === 0 ? Math.sin(u) : Math.tan(h) / Math.tan(theta);
    ring(RIGHT + h, Math.acos(clamp(cosine, -1, 1)), part * theta * Math.cos(u) * Math.cos(h));
  }
  // Half the sky stands for all of it: weights of m < 0 vanish. The least luminance lies in the plane of sun and zenith.
  for (let l = 1; l < bands; ++l) for (let k = 0; k < 3; ++k) out.fill(0, k * count + l * l, k * count + l * (l + 1));
  const plane = Array.from({ length: 720 }, (_, i) => ((i + 0.5) / 720 - 0.5) * Math.PI);
  const all = plane.map((at) => luminanceOf(radianceOf(sky, Math.cos(at), Math.abs(at - theta), Math.cos(at - theta))));
  return { weights: out, least: Math.min(...all), sky };
}

// ---- The sun: its disc's radiance (light/sun_disc.py), and its place over a town -----------------------------------------
function discRadiance(theta, tau) {
  const rgb = [0, 0, 0];
  if (!data.disc || theta > RIGHT + 1e-9) return rgb;
  const mass = 1 / (Math.cos(theta) + 0.15 * (93.885 - theta / DEGREE) ** -1.253);
  const beta = Math.max(0.04608 * tau - 0.04586, 0);
  for (const [r, g, b, still, aerosol, gases, vapour] of data.disc.rows) {
    const lines = (1.41 * gases * mass) / (1 + 118.93 * gases * mass) ** 0.45, wet = vapour * mass;
    const passed = Math.exp(-mass * (still + beta * aerosol) - lines - (0.2385 * wet) / (1 + 20.07 * wet) ** 0.45);
    [r, g, b].forEach((value, k) => { rgb[k] += passed * value; });
  }
  return rgb;
}

// Zenith angle and azimuth (from east towards north) of the sun without refraction, to 0.02 degrees: the low-precision
// formulas of the Astronomical Almanac. `minutes` are the local clock's, `offset` its hours ahead of UTC.
function sunOver({ latitude, longitude, date, offset }, minutes) {
  const days = Date.parse(`${date}T00:00Z`) / 864e5 - 10957.5 + (minutes - 60 * offset) / 1440;
  const anomaly = (357.528 + 0.9856003 * days) * DEGREE, mean = 280.46 + 0.9856474 * days;
  const ecliptic = (mean + 1.915 * Math.sin(anomaly) + 0.02 * Math.sin(2 * anomaly)) * DEGREE;
  const tilt = (23.439 - 4e-7 * days) * DEGREE, declination = Math.asin(Math.sin(tilt) * Math.sin(ecliptic));
  const ascension = Math.atan2(Math.cos(tilt) * Math.sin(ecliptic), Math.cos(ecliptic)), north = latitude * DEGREE;
  const hour = (280.46062 + 360.98564737 * days + longitude) * DEGREE - ascension;
  const [sinD, cosD, sinN, cosN] = [Math.sin(declination), Math.cos(declination), Math.sin(north), Math.cos(north)];
  const up = sinD * sinN + cosD * cosN * Math.cos(hour), towardsNorth = sinD * cosN - cosD * sinN * Math.cos(hour);
  return { zenith: Math.acos(clamp(up, -1, 1)), azimuth: Math.atan2(towardsNorth, -cosD * Math.sin(hour)) };
}

// Minutes of the day's first and last light, and of its highest sun.
function day() {
  const minutes = Array.from({ length: 289 }, (_, k) => 5 * k), zeniths = minutes.map((one) => sunOver(state, one).zenith);
  const up = minutes.filter((_, k) => zeniths[k] < 89.5 * DEGREE);
  return { first: up[0] ?? 0, last: up[up.length - 1] ?? 1440, noon: minutes[zeniths.indexOf(Math.min(...zeniths))] };
}

// ---- State ---------------------------------------------------------------------------------------------------------------
const sunName = data.sun, moves = Boolean(data.moves), PLACE = ["date", "latitude", "longitude", "offset"];
const defaults = {
  table: data.best, bands: Math.min(5, tableOf(data.best).bands), view: data.disc ? "sun" : "bounces", ground: data.grounds[0],
  window: "none", difference: "bands", latitude: 43.3, longitude: 5.4, date: "2026-08-12", offset: 2, minutes: -1,
};
for (const { dataset: { axis, unit: angle }, min, max } of controls.filter((one) => one.dataset.axis)) {
  defaults[axis] = axis === "turbidity" ? clamp(3, +min, +max) : ((+min + +max) / 2) * (angle ? DEGREE : 1);
}
Object.assign(defaults, { sun_azimuth: data.azimuth ?? 10 * DEGREE }, sunName && { [sunName]: 79 * DEGREE });
const state = { ...defaults };

// Changes the state and shows it. A time of day of 0 or more places the sun; a sun placed otherwise has none, -1.
function set(changes) {
  for (const [key, value] of Object.entries(changes)) {
    const number = typeof defaults[key] === "number";
    if (!(key in defaults)) throw new Error(`Invalid ${key}. Should be one of: ${Object.keys(defaults).join(", ")}.`);
    if (number && !Number.isFinite(+value)) throw new Error(`Invalid ${key} ${value}. Should be a number.`);
    if (key === "table" && !tableOf(value)) throw new Error(`Invalid table ${value}. Should be one of: ${skylight.tables}.`);
    state[key] = number ? +value : value;
  }
  state.bands = clamp(Math.round(state.bands), 1, tableOf(state.table).bands);
  const placed = sunName in changes || "sun_azimuth" in changes;
  if (placed && !(changes.minutes >= 0)) state.minutes = -1;
  if (moves && state.minutes >= 0 && ["minutes", ...PLACE].some((key) => key in changes)) {
    const { zenith, azimuth } = sunOver(state, state.minutes);
    Object.assign(state, { [sunName]: zenith, sun_azimuth: azimuth });
  }
  if (sunName) {
    state[sunName] = clamp(state[sunName], ...data.zeniths);
    state.sun_azimuth -= 2 * Math.PI * Math.floor(state.sun_azimuth / (2 * Math.PI));
  }
  return refresh();
}

function toFragment() {
  const changed = Object.entries(state).filter(([key, value]) => value !== defaults[key]);
  const text = String(new URLSearchParams(changed.map(([key, value]) => [key, +value ? +(+value).toPrecision(8) : value])));
  if (text || location.hash.includes("=")) history.replaceState(null, "", `#${text || "="}`);
}

function fromFragment() {
  const told = location.hash.includes("=") ? [...new URLSearchParams(location.hash.slice(1))] : [];
  const read = told.map(([key, value]) => [key, typeof defaults[key] === "number" ? +value : value]);
  return Object.fromEntries(read.filter(([key, value]) => key in defaults && !Number.isNaN(value)
    && (key !== "table" || tableOf(value))));
}

const sunDirection = ({ [sunName]: zenith = 0, sun_azimuth: azimuth = 0 } = state) => (
  [Math.sin(zenith) * Math.cos(azimuth), Math.sin(zenith) * Math.sin(azimuth), Math.cos(zenith)]);

// ---- The light of a state ------------------------------------------------------------------------------------------------
// The weights of red, green and blue, or three times those of the one channel.
const channelsOf = (weights, count) => [0, 1, 2].map((k) => (
  data.channels === 1 ? weights.subarray(0, count) : weights.subarray(k * count, (k + 1) * count)));

// A table's weights over the ground that the state asks for, in so many bands, windowed or not.
function shaped(module, raw, table, bands = module.BANDS, window = "none") {
  const weights = Float32Array.from(raw), { ground } = state;
  if (table.ground === "black" && ground === "mirror") mirror(weights, module.WEIGHTS);
  if (ground === "albedo" && module.applyGround) module.applyGround(weights, module.CHANNELS.map(() => 0.25));
  weights.forEach((_, i) => { if (i % module.WEIGHTS >= bands * bands) weights[i] = 0; });
  return window === "sinc" && module.applyWindow ? module.applyWindow(weights, bands) : weights;
}

// The light on level ground by the sky, a channel each: exact over black ground; of a mirrored sky half the sphere's
// |cosine|, whose first three degrees are nearly all of it; of irradiance its value upwards.
function onGround(raw, module, table) {
  const share = (i, by) => by * Math.sqrt((2 * Math.floor(Math.sqrt(i)) + 1) / (4 * Math.PI));
  const shares = table.irradiance ? Array.from({ length: module.BANDS }, (_, l) => [l * (l + 1), 1])
    : table.ground === "mirror" ? [[0, Math.PI], [6, Math.PI / 4], [20, -Math.PI / 24]] : [[2, (4 * Math.PI) / 3]];
  return module.CHANNELS.map((_, k) => shares.filter(([i]) => i < module.WEIGHTS)
    .reduce((sum, [i, by]) => sum + share(i, by) * raw[k * module.WEIGHTS + i], 0));
}

// All that is shown of a state.
function lightNow() {
  const table = tableOf(state.table), module = loaded.get(state.table), count = module.WEIGHTS;
  const inputs = table.inputs.map((name) => state[name]), tau = state.turbidity ?? data.tau;
  const raw = module.weights(...inputs), weights = shaped(module, raw, table, state.bands, state.window);
  const all = shaped(module, raw, table), wide = data.disc ? data.disc.half_angle : 0;
  const sun = sunName ? discRadiance(state[sunName], tau) : [0, 0, 0], skyLux = luminanceOf(onGround(raw, module, table));
  const sunLux = luminanceOf(scaled(sun, Math.PI * Math.sin(wide) ** 2)) * Math.max(Math.cos(state[sunName]), 0) || 0;
  const lux = Math.max(skyLux + sunLux, 1e-6);
  const light = { table, module, count, inputs, raw, weights, all, wide, skyLux, sunLux };
  // As render/tone.py has it; relative skies, whose zenith is 1, have nothing that an eye adapts to.
  Object.assign(light, { bands: state.bands, exposure: (4.9 / lux) * (lux > 100 ? lux / 50000 : 1) ** 0.16 });
  light.sun = state.view === "sun" ? sun : [0, 0, 0];
  if (data.formula) {
    const exact = truth(state[sunName], tau, module.BANDS);
    if (table.ground === "mirror") mirror(exact.weights, count);
    light.sky = exact.sky;
    light.truth = turned(exact.weights, count, state.sun_azimuth);
    // E_mean of the bands shown (Habel et al. 2008, eq. 3).
    const lost = [0, 1, 2].map((k) => light.truth.slice(k * count, k * count + state.bands ** 2)
      .reduce((sum, value, i) => sum + (raw[k * count + i] - value) ** 2, 0));
    light.eMean = Math.sqrt(Math.max(...lost)) / exact.least;
  }
  return light;
}

// Microseconds of a call: the median over batches of 256, once the browser has compiled the code.
function timeOf({ module, inputs }) {
  const out = module.weights(...inputs), batches = Array.from({ length: 24 }, () => {
    const begin = performance.now();
    for (let i = 0; i < 256; ++i) module.weights(...inputs, out);
    return (1000 * (performance.now() - begin)) / 256;
  });
  return batches.slice(12).sort((a, b) => a - b)[6];
}

// ---- Discs: the sky, its expansion, their difference ---------------------------------------------------------------------
const SIDE = 144, LOW = [33, 102, 172], HIGH = [178, 24, 43];

// Tone mapping as tone.frag.glsl and render/tone.py have it; 0 to 255, into a picture.
function display(r, g, b, image, place) {
  const luminance = 0.2126729 * r + 0.7151522 * g + 0.072175 * b, by = (1 + luminance / 25) / (1 + luminance);
  const mapped = luminance * by, hue = [r, g, b].map((value) => Math.max(value, 0) * by);
  const grey = Math.min(mapped, 1), most = Math.max(...hue), room = 1 - grey;
  const share = room > 0 ? (most - grey) / room : 0;
  const beyond = (Math.min(share, 0.6) + 0.4 * (1 - Math.exp(-Math.max(share - 0.6, 0) / 0.4))) * room;
  for (let k = 0; k < 3; ++k) {
    const paler = most - grey > 1e-6 ? grey + ((hue[k] - grey) * beyond) / (most - grey) : hue[k];
    const value = clamp(0.5 * (paler + (most > 0 ? (hue[k] * (grey + beyond)) / most : hue[k])), 0, 1);
    image[place + k] = 255 * (value > 0.0031308 ? 1.055 * value ** (1 / 2.4) - 0.055 : 12.92 * value);
  }
}

// The pixels of a disc, as on a map: north up, east right, the zenith in the middle, heights evenly outwards.
const pixels = Array.from({ length: SIDE * SIDE }, (_, i) => {
  const x = (2 * (i % SIDE) + 1) / SIDE - 1, y = 1 - (2 * Math.floor(i / SIDE) + 1) / SIDE, radius = Math.hypot(x, y);
  const flat = Math.sin(radius * RIGHT) / radius;
  return { place: 4 * i, radius, along: [x * flat, y * flat, Math.cos(radius * RIGHT)] };
}).filter(({ radius }) => radius < 1);

const bases = [];
function pixelBasis(bands) {
  const make = () => new Float32Array(pixels.length * bands * bands);
  bases[bands] ??= pixels.reduce((values, { along }, i) => basis(...along, bands, values, i * bands * bands), make());
  return bases[bands];
}

// Radiance of all pixels by the first bands of weights, three numbers each.
function expanded(weights, { BANDS, WEIGHTS }, bands) {
  const values = pixelBasis(BANDS), used = bands * bands, out = new Float32Array(3 * pixels.length);
  channelsOf(weights, WEIGHTS).forEach((own, k) => {
    for (let i = 0; i < pixels.length; ++i) {
      let sum = 0;
      for (let j = 0; j < used; ++j) sum += own[j] * values[i * WEIGHTS + j];
      out[3 * i + k] = sum;
    }
  });
  return out;
}

function exactly(sky) {
  const out = new Float32Array(3 * pixels.length), sun = sunDirection();
  pixels.forEach(({ along }, i) => {
    const cosine = clamp(dot(along, sun), -1, 1);
    out.set(radianceOf(sky, along[2], Math.acos(cosine), cosine), 3 * i);
  });
  return out;
}

function paint(name, colour) {
  const context = $(name).getContext("2d"), image = context.createImageData(SIDE, SIDE);
  pixels.forEach(({ place }, i) => {
    colour(i, image.data, place);
    image.data[place + 3] = 255;
  });
  context.putImageData(image, 0, 0);
}

// One digit, rounded up.
const nice = (value, power = 10 ** Math.floor(Math.log10(value))) => Math.ceil(value / power) * power;

function paintDiscs(light) {
  const { module, bands, exposure } = light, own = state.difference === "table" && light.truth;
  const sky = light.sky ? exactly(light.sky) : expanded(light.all, module, module.BANDS);
  const few = expanded(light.weights, module, bands), radius = (state[sunName] ?? 0) / RIGHT;
  const by = (of) => (i, image, place) => (
    display(of[3 * i] * exposure, of[3 * i + 1] * exposure, of[3 * i + 2] * exposure, image, place));
  // Of the table's own error both are expansions in the same bands, over the table's own ground.
  const one = own ? expanded(light.raw, module, bands) : few, other = own ? expanded(light.truth, module, bands) : sky;
  const mean = pixels.reduce((sum, _, i) => sum + luminanceOf(sky, 3 * i), 0) / pixels.length;
  const off = Float32Array.from(pixels, (_, i) => (luminanceOf(one, 3 * i) - luminanceOf(other, 3 * i)) / mean);
  light.scale = nice(Math.max(off.map(Math.abs).sort()[Math.floor(0.98 * off.length)], 1e-9));
  paint("sky", by(sky));
  paint("few", by(few));
  paint("difference", (i, image, place) => {
    const share = clamp(off[i] / light.scale, -1, 1), end = share < 0 ? LOW : HIGH;
    for (let k = 0; k < 3; ++k) image[place + k] = 247 + (end[k] - 247) * Math.abs(share);
  });
  $("discs").style.setProperty("--east", radius * Math.cos(state.sun_azimuth));
  $("discs").style.setProperty("--north", radius * Math.sin(state.sun_azimuth));
  say("low", `−${percent(light.scale)}`);
  say("high", `+${percent(light.scale)}`);
  say("few-name", bands > 1 ? `${bands} bands of the table` : "1 band of the table");
}

// ---- The courtyard -------------------------------------------------------------------------------------------------------
const SHADOW_SIDE = 2048;
// Of each degree: irradiance / pi of a surface that nothing shades, over the radiance.
const COSINE_LOBE = [1, 2 / 3, 1 / 4, 0, -1 / 24, 0, 1 / 64];

async function makeScene() {
  const canvas = $("canvas"), gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) return null;
  const name = gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  if (/swiftshader|llvmpipe|software|basic render/i.test(name)) most = 640 * 360;
  const court = await unpackCourtyard(), { columns, units, bands } = court;
  const count = bands * bands, seen = columns.colour.length;
  const woven = (names, by, many = seen, Kind = Float32Array) => {
    const out = new Kind(names.length * many);
    names.forEach((own, k) => { for (let i = 0; i < many; ++i) out[names.length * i + k] = columns[own][i] * by; });
    return out;
  };
  const positions = woven(["x", "y", "z"], units.position, columns.x.length), open = gl.createBuffer();
  const normals = woven(["normal_x", "normal_y", "normal_z"], units.normal);
  const four = (k) => woven([0, 1, 2, 3].map((i) => `component_${4 * k + i}`), 1, seen, Int8Array);
  const lit = meshOf(gl, [
    [3, positions], [3, normals], [2, woven(["u", "v"], units.uv)], [2, woven(["colour", "material"], 1)],
    [3, new Float32Array(3 * seen), open], [4, four(0)], [4, four(1)], [4, four(2)], [4, four(3)],
  ], columns.seen);
  const casting = meshOf(gl, [[3, positions]], [...columns.seen, ...columns.hidden]), behind = meshOf(gl, [], [0, 1, 2]);
  const define = `#define SHADOW_SIDE ${SHADOW_SIDE}.0\n#define BANDS ${bands}\n#define WEIGHTS ${count}\n`;
  const [scene, sky, shadow] = ["scene", "sky", "shadow"].map((kind) => programOf(gl, kind, define));
  const map = makeShadowMap(gl), camera = cameraOf(court.camera), rows = court.scales.length;
  const matrix = Float64Array.from(columns.matrix, (value, i) => value * court.scales[Math.floor(i / (4 * count))]);
  let last = "", towards = null, openBasis = null;
  await makeTextures(gl, court.blobs);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);

  // The vertices' light where nothing shades, for that view alone.
  function fillOpen(weights) {
    if (!openBasis) {
      openBasis = new Float32Array(seen * count);
      for (let i = 0; i < seen; ++i) basis(...unit([...normals.subarray(3 * i, 3 * i + 3)]), bands, openBasis, i * count);
    }
    const values = new Float32Array(3 * seen);
    weights.forEach((own, k) => own.forEach((weight, j) => {
      const by = weight * COSINE_LOBE[Math.floor(Math.sqrt(j))];
      if (by) for (let i = 0; i < seen; ++i) values[3 * i + k] += by * openBasis[i * count + j];
    }));
    gl.bindBuffer(gl.ARRAY_BUFFER, open);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, values);
  }

  // What compression.uniforms makes of the light; of direct light alone where nothing bounces.
  function componentsOf(weights, sun, bounces) {
    return Float32Array.from({ length: 3 * rows }, (_, at) => {
      const k = at % 3, direct = Math.floor(at / 3) * 4 * count, bounced = direct + (1 + k) * count;
      return weights[k].reduce((sum, weight, i) => (
        sum + matrix[direct + i] * weight + (bounces ? matrix[bounced + i] * (weight + sun[k][i]) : 0)), 0);
    });
  }

  function drawShadows(sun) {
    if (last === String(sun)) return;
    last = String(sun);
    towards = towardsSun(positions, sun);
    gl.bindFramebuffer(gl.FRAMEBUFFER, map);
    gl.viewport(0, 0, SHADOW_SIDE, SHADOW_SIDE);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1.5, 4);
    shadow({ towardsSun: towards.matrix });
    casting();
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  function draw(light) {
    const sun = sunDirection(), { wide, exposure } = light, aspect = canvas.width / canvas.height, { view } = state;
    const weights = channelsOf(light.weights, light.count).map((own) => own.subarray(0, count));
    const aim = basis(...sun, bands, new Float64Array(count)).map((value, i) => (i < light.bands ** 2 ? value : 0));
    const disc = light.sun.map((value) => aim.map((one) => one * value * 2 * Math.PI * (1 - Math.cos(wide))));
    if (view === "sun" || !towards) drawShadows(sun);
    if (view === "open") fillOpen(weights);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    scene({
      camera: camera.matrix(aspect), towardsSun: towards.matrix, texel: towards.texel, open: view === "open" ? 1 : 0,
      light: componentsOf(weights, disc, view === "bounces" || view === "sun"), palette: court.palette.flat(),
      sun, sunlight: scaled(light.sun, Math.sin(wide) ** 2), rings: court.rings.edges, ringColour: court.rings.colour,
      exposure, paving: 0, painted: 1, shadows: 2,
    });
    lit();
    const plain = channelsOf(light.all, light.count);
    sky({
      ...camera.frame(aspect), sun, disc: light.sun, halfAngle: view === "sun" ? wide : 0, exposure,
      ...(light.sky && { exact: 1, zenith: light.sky.values, perez: light.sky.shape.flat(), toRgb: data.formula.columns }),
      weights: Float32Array.from({ length: 3 * count }, (_, i) => plain[i % 3][Math.floor(i / 3)] ?? 0),
    });
    behind();
  }

  return { canvas, draw, finish: () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)) };
}

// Returns what draws vertices of attributes, [size, values, buffer], by their places; bytes count as numbers from -1 to 1.
function meshOf(gl, attributes, indices) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  attributes.forEach(([size, values, buffer = gl.createBuffer()], place) => {
    const bytes = values instanceof Int8Array;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, bytes ? gl.BYTE : gl.FLOAT, bytes, 0, 0);
  });
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint16Array.from(indices), gl.STATIC_DRAW);
  return () => {
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_SHORT, 0);
  };
}

// Returns what uses a program with values for its uniforms by their names.
function programOf(gl, name, define) {
  const program = gl.createProgram();
  for (const [end, kind] of [["vert", gl.VERTEX_SHADER], ["frag", gl.FRAGMENT_SHADER]]) {
    const shader = gl.createShader(kind), tone = end === "frag" ? data.shaders["tone.frag"] : "";
    gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${define}${tone}${data.shaders[`${name}.${end}`]}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  const logs = () => gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`Shader ${name}: ${logs()}`);
  const setters = { [gl.FLOAT]: "1fv", [gl.FLOAT_VEC2]: "2fv", [gl.FLOAT_VEC3]: "3fv" };
  Object.assign(setters, { [gl.FLOAT_MAT3]: "Matrix3fv", [gl.FLOAT_MAT4]: "Matrix4fv" });
  const uniforms = Array.from({ length: gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) }, (_, i) => {
    const { name: full, type } = gl.getActiveUniform(program, i);
    return { key: full.replace("[0]", ""), setter: setters[type] ?? "1iv", place: gl.getUniformLocation(program, full) };
  });
  return (values) => {
    gl.useProgram(program);
    for (const { key, setter, place } of uniforms.filter((one) => one.key in values)) {
      const value = typeof values[key] === "number" ? [values[key]] : values[key];
      gl[`uniform${setter}`](place, ...(setter.startsWith("Matrix") ? [false, value] : [value]));
    }
  };
}

// A depth texture that compares and interpolates, on unit 2; returns the frame that fills it.
function makeShadowMap(gl) {
  const frame = gl.createFramebuffer(), texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE2);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW_SIDE, SHADOW_SIDE);
  for (const name of ["MIN_FILTER", "MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl.LINEAR);
  for (const name of ["WRAP_S", "WRAP_T"]) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
  gl.drawBuffers([gl.NONE]);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return frame;
}

// The paving on unit 0; the other textures, layer by layer, on unit 1.
async function makeTextures(gl, { paving, ...others }) {
  const side = 512, small = { resizeWidth: side, resizeHeight: side, resizeQuality: "pixelated" };
  const picture = (bytes, more) => createImageBitmap(new Blob([bytes], { type: "image/webp" }),
    { colorSpaceConversion: "none", imageOrientation: "flipY", ...more });
  const floor = await picture(paving), layers = await Promise.all(Object.values(others).map((one) => picture(one, small)));
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, floor);
  gl.generateMipmap(gl.TEXTURE_2D);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  const sharper = gl.getExtension("EXT_texture_filter_anisotropic");
  if (sharper) gl.texParameterf(gl.TEXTURE_2D, sharper.TEXTURE_MAX_ANISOTROPY_EXT, 4);
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 10, gl.SRGB8_ALPHA8, side, side, layers.length);
  const fill = (one, k) => gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, k, side, side, 1, gl.RGBA, gl.UNSIGNED_BYTE, one);
  layers.forEach(fill);
  gl.generateMipmap(gl.TEXTURE_2D_ARRAY);
  gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
}

// A pinhole camera as render/camera.py has it; the matrix stands column by column.
function cameraOf({ eye, target, field }) {
  const ahead = unit(target.map((value, i) => value - eye[i])), right = unit([ahead[1], -ahead[0], 0]);
  const up = cross(right, ahead), reach = Math.tan((field * DEGREE) / 2), near = 0.3, deep = (800 + near) / (800 - near);
  const matrix = (aspect) => {
    const rows = [scaled(right, 1 / (reach * aspect)), scaled(up, 1 / reach), scaled(ahead, deep), ahead];
    const moved = rows.map((row, k) => -dot(row, eye) - (k === 2 ? near * (1 + deep) : 0));
    return [0, 1, 2].flatMap((k) => rows.map((row) => row[k])).concat(moved);
  };
  return { matrix, frame: (aspect) => ({ ahead, across: scaled(right, reach * aspect), upward: scaled(up, reach) }) };
}

// Parallel light's view of all that is near, as tight as it goes, and how wide one of its texels is in metres.
function towardsSun(positions, sun) {
  const side = Math.hypot(sun[0], sun[1]) > 1e-6 ? unit([-sun[1], sun[0], 0]) : [0, 1, 0];
  const rows = [side, cross(sun, side), scaled(sun, -1)], low = [1e9, 1e9, 1e9], high = [-1e9, -1e9, -1e9];
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    for (let k = 0; k < 3 && Math.abs(x) < 20 && Math.abs(y) < 20; ++k) {
      const value = rows[k][0] * x + rows[k][1] * y + rows[k][2] * z;
      low[k] = Math.min(low[k], value);
      high[k] = Math.max(high[k], value);
    }
  }
  const by = low.map((value, k) => 2 / (high[k] - value + 0.2));
  const moved = low.map((value, k) => -0.5 * (high[k] + value) * by[k]);
  const matrix = [0, 1, 2].flatMap((k) => [...rows.map((row, i) => row[k] * by[i]), 0]).concat(moved, 1);
  return { matrix, texel: 2 / Math.min(by[0], by[1]) / SHADOW_SIDE };
}

// ---- What the reader sees ------------------------------------------------------------------------------------------------
// As many pixels as the screen has for it, but no more than a machine without a graphics card draws in a tenth of a second.
let most = 1600 * 900, scene = null, current = null, playing = 0, waiting = null;
const number = (value, digits = 3) => value.toLocaleString("en", { maximumSignificantDigits: digits });
const percent = (value) => `${number(100 * value, 2)} %`;
const clock = (minutes) => [minutes / 60, minutes % 60].map((value) => String(Math.floor(value)).padStart(2, "0")).join(":");
const compass = (azimuth) => ["E", "NE", "N", "NW", "W", "SW", "S", "SE"][Math.round(azimuth / (Math.PI / 4)) % 8];
const say = (name, text) => Object.assign($(name) ?? {}, { textContent: text });

function redraw() {
  if (!scene || !current) return;
  const { canvas } = scene, { width: across, height: down } = canvas.parentElement.getBoundingClientRect();
  const by = Math.min(window.devicePixelRatio || 1, Math.sqrt(most / Math.max(across * down, 1)));
  const [width, height] = [across, down].map((value) => Math.max(Math.round(value * by), 1));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  scene.draw(current);
}

function refresh() {
  current = lightNow();
  redraw();
  paintDiscs(current);
  tell(current);
  toFragment();
  return { ...state };
}

function tell({ table, skyLux, sunLux, eMean }) {
  const height = 90 - state[sunName] / DEGREE, time = state.minutes >= 0 ? `${clock(state.minutes)}, ` : "";
  if (sunName) say("when", `${time}sun ${number(height)}° high${moves ? `, in the ${compass(state.sun_azimuth)}` : ""}`);
  say("lux", data.disc ? `${number(skyLux / 1000)} klx of sky, ${number(sunLux / 1000)} of sun` : number(skyLux));
  say("bytes", `${table.bytes.toLocaleString("en")} bytes`);
  say("error", eMean === undefined ? `at most ${percent(table.e_mean)}` : percent(eMean));
  say("time", table.microseconds ? `${number(table.microseconds, 2)} µs` : "…");
  if (!table.microseconds && loaded.size === data.tables.length) setTimeout(measure, 50);
  controls.forEach(showIn);
  if ($("engine").open) say("code", codeFor($("format").value));
}

// A control shows the sun's zenith angle as its height, and angles in degrees.
const shownOf = ({ dataset: { key, unit: angle } }) => (
  key === "height" ? 90 - state[sunName] / DEGREE : angle ? state[key] / DEGREE : state[key]);
const changeOf = ({ dataset: { key, unit: angle }, value }) => (
  key === "height" ? { [sunName]: (90 - value) * DEGREE } : { [key]: angle ? value * DEGREE : value });

function showIn(control) {
  const { key, unit: angle = "" } = control.dataset, value = shownOf(control), range = control.type === "range";
  if (key === "bands") control.max = tableOf(state.table).bands;
  if (key === "minutes") [control.min, control.max] = [day().first, day().last];
  if (control.type === "radio") control.checked = control.value === value;
  else if (!(key === "minutes" && value < 0) && (range || control !== document.activeElement)) {
    control.value = typeof value === "number" ? +value.toFixed(4) : value;
  }
  const told = range && control.parentElement.querySelector(".value");
  const words = key === "minutes" ? (value < 0 ? "" : clock(value)) : `${number(+value)}${angle}`;
  if (told) told.textContent = words;
  if (range) control.setAttribute("aria-valuetext", words || "sun placed by hand");
}

// What an engine's programmer wants of this light.
function codeFor(format) {
  const { table, module, weights, count, inputs, bands } = current, { ground, window } = state;
  const float = (value) => String(+value.toPrecision(9)).replace(/^(-?\d+)$/, "$1.0");
  const about = `${table.name}, ${table.bytes} bytes, ${module.UNIT}`, upper = table.prefix.toUpperCase();
  if (format === "c") {
    return `#include "skylight_sh.h" /* ${about} */\n\nfloat w[${upper}_CHANNELS][${upper}_WEIGHTS];\n`
      + `int status = ${table.prefix}_weights(${inputs.map((value) => `${float(value)}f`).join(", ")}, w);`
      + ` /* ${table.inputs.join(", ")} */\n`;
  }
  const own = channelsOf(weights, count).map((one) => Array.from(one.subarray(0, bands * bands), (v) => +v.toPrecision(7)));
  if (format === "json") {
    const named = (names, of) => Object.fromEntries(names.map((name, i) => [name, of[i]]));
    const told = { table: table.name, unit: module.UNIT, inputs: named(table.inputs, inputs), bands, ground, window };
    return JSON.stringify({ ...told, weights: named(module.CHANNELS, own) }, null, 1);
  }
  const rows = own[0].map((_, i) => `  vec3(${own.map((one) => float(one[i])).join(", ")})`).join(",\n");
  return `// ${about}; ${bands} bands, ground: ${ground}, window: ${window}.\n`
    + `// Real orthonormal SH without the Condon-Shortley sign, at l*(l+1)+m, z up.\n`
    + `const vec3 sky[${bands * bands}] = vec3[](\n${rows}\n);\n`;
}

// ---- What the reader does ------------------------------------------------------------------------------------------------
// Gathers changes and shows them with the next picture: pointers tell more often than that.
function soon(changes) {
  if (!waiting) requestAnimationFrame(() => { set(Object.assign(waiting, (waiting = null))); });
  waiting = { ...waiting, ...changes };
}

// What a button asks for: a sun in degrees, or noon at the place; a turbidity where the table has it.
function preset({ height, azimuth, noon, turbidity }) {
  const sun = noon ? { minutes: day().noon } : { [sunName]: (90 - height) * DEGREE, sun_azimuth: azimuth * DEGREE };
  set("turbidity" in state ? { ...sun, turbidity } : sun);
}

function play() {
  const step = () => {
    const { first, last } = day();
    set({ minutes: state.minutes < first || state.minutes >= last ? first : state.minutes + 2 });
    playing = requestAnimationFrame(step);
  };
  cancelAnimationFrame(playing);
  playing = playing ? 0 : requestAnimationFrame(step);
  say("play", playing ? "Pause" : "Play the day");
}

async function copy() {
  const done = await navigator.clipboard.writeText(codeFor($("format").value)).then(() => true, () => false);
  if (!done) getSelection().selectAllChildren($("code"));
  say("copied", done ? "Copied." : "Selected: press Ctrl+C.");
}

// Lets a pointer move the sun: from where it stands, or to a `place` of its own.
function steer(element, place) {
  let from = null;
  const follow = (event) => {
    const zenith = from.zenith + 0.2 * DEGREE * (event.clientY - from.y);
    soon(place ? place(event) : { [sunName]: zenith, sun_azimuth: from.azimuth - 0.35 * DEGREE * (event.clientX - from.x) });
  };
  element.addEventListener("pointerdown", (event) => {
    from = { x: event.clientX, y: event.clientY, zenith: state[sunName], azimuth: state.sun_azimuth };
    element.setPointerCapture(event.pointerId);
    $("hint")?.classList.add("gone");
    if (place) follow(event);
  });
  element.addEventListener("pointermove", (event) => { if (from) follow(event); });
  for (const name of ["pointerup", "pointercancel"]) element.addEventListener(name, () => { from = null; });
}

function inDisc({ target, clientX, clientY }) {
  const { left, top, width, height } = target.getBoundingClientRect();
  const x = (2 * (clientX - left)) / width - 1, y = 1 - (2 * (clientY - top)) / height;
  return { [sunName]: Math.min(Math.hypot(x, y), 1) * RIGHT, sun_azimuth: Math.atan2(y, x) };
}

function press(event) {
  const by = (event.shiftKey ? 5 : 1) * DEGREE, { key, target } = event, here = target.closest(".stage, .discs");
  const [down, left] = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1] }[key] ?? [];
  if (event.ctrlKey || event.metaKey || event.altKey || target.closest("input, select, textarea, button, summary")) return;
  if (left !== undefined && moves && here) {
    set({ [sunName]: state[sunName] + down * by, sun_azimuth: state.sun_azimuth + left * by });
  } else if (/^[1-7]$/.test(key)) set({ bands: +key });
  else if (key === " " && $("play") && here) play();
  else return;
  event.preventDefault();
}

function listen() {
  controls.forEach((one) => one.addEventListener("input", () => { if (one.value !== "") soon(changeOf(one)); }));
  const buttons = document.querySelectorAll("#player [data-preset]");
  buttons.forEach((one) => one.addEventListener("click", () => preset(JSON.parse(one.dataset.preset))));
  $("play")?.addEventListener("click", play);
  $("copy").addEventListener("click", copy);
  const code = () => say("code", codeFor($("format").value));
  $("engine").addEventListener("toggle", code);
  $("format").addEventListener("input", code);
  if (moves) ["sky", "few", "difference"].forEach((name) => steer($(name), inDisc));
  if (moves && scene) steer($("stage"));
  document.addEventListener("keydown", press);
  addEventListener("hashchange", () => { if (location.hash.includes("=")) set({ ...defaults, ...fromFragment() }); });
  if (scene) new ResizeObserver(redraw).observe($("stage"));
}

async function start() {
  const texts = await moduleTexts();
  Object.assign(state, fromFragment());
  await load(state.table, texts);
  scene = data.courtyard ? await makeScene() : null;
  set({ bands: state.bands });
  scene?.finish();
  if (scene) $("stage").classList.add("drawn");
  for (const { name } of data.tables) await load(name, texts);
  listen();
  measure();
}

// Times the table shown, when nothing else is to do.
function measure() {
  if (current.table.microseconds) return;
  current.table.microseconds = timeOf(current);
  tell(current);
}

const skylight = {
  tables: data.tables.map(({ name }) => name),
  weights: (table, ...inputs) => {
    if (!loaded.has(table)) throw new Error(`Invalid table ${table}. Should be one of: ${skylight.tables}.`);
    return loaded.get(table).weights(...inputs.slice(0, tableOf(table).inputs.length));
  },
  set,
  state: () => ({ ...state }),
  errors: () => ({
    e_mean: current.eMean ?? null, measured: current.table.e_mean, difference: current.scale,
    microseconds: current.table.microseconds ?? null, sky_lux: current.skyLux, sun_lux: current.sunLux,
  }),
};
window.skylight = skylight;
skylight.ready = start();
