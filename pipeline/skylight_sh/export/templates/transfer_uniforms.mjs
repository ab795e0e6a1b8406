// A frame's uniforms of compressed transfer, for browsers and Node. CC0-1.0.
//
// data: what transfer_uniforms.json holds. sky and sun: SH weights of radiance, red, then green, then blue, in one flat array,
// l*(l+1)+m each, of data.bands bands or more. sun is the disc that you light directly, with your own shadows, and reaches the
// vertices by bounces alone; leave it out where there is none. Returns red, green and blue of the mean and of each component,
// as gl.uniform3fv takes them.
export function uniforms(data, sky, sun) {
  const weights = data.bands * data.bands;
  const out = new Float32Array(3 * data.matrix.length);
  data.matrix.forEach((row, k) => {
    for (let channel = 0; channel < 3; ++channel) {
      let sum = 0;
      for (let i = 0; i < weights; ++i) {
        const fromSky = sky[(channel * sky.length) / 3 + i];
        const fromSun = sun ? sun[(channel * sun.length) / 3 + i] : 0;
        sum += row[i] * fromSky + row[weights * (1 + channel) + i] * (fromSky + fromSun);
      }
      out[3 * k + channel] = sum;
    }
  });
  return out;
}
