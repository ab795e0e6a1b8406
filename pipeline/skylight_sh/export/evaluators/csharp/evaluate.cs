using System;
using Real = System.Single;

public static partial class SkylightSh
{
    // Fills the first `used` sums of each class: each term's row times its product of functions.
    static void AddTerms(ReadOnlySpan<Real> first, ReadOnlySpan<Real> others, int used, Span<Real> sums)
    {
        ReadOnlySpan<byte> lengths = Terms.Lengths;
        ReadOnlySpan<Real> rows = Terms.Rows;
        sums.Clear();
        int run = 0, row = 0;
        for (int k = 0; k < ClassCount; ++k)
        {
            Span<Real> own = sums.Slice(k * Width, used);
            for (int other = 0; other < OtherCount; ++other, ++run)
                for (int i = 0; i < lengths[run]; ++i, row += Width)
                {
                    Real product = first[i] * others[other];
                    ReadOnlySpan<Real> coefficients = rows.Slice(row, own.Length);
                    for (int column = 0; column < own.Length; ++column) own[column] += product * coefficients[column];
                }
        }
    }

    // A channel's weight of one column of sums.
    static Real Mix(ReadOnlySpan<Real> factors, ReadOnlySpan<Real> sums, int channel, int column)
    {
#if SKYLIGHT_SH_IS_MIXED
        Real value = 0;
        for (int k = 0; k < ClassCount; ++k) value += factors[channel * ClassCount + k] * sums[k * Width + column];
        return value;
#else
        return factors[0] * sums[channel * Width + column];
#endif
    }

    // Fills `found` with the weights of the first `bands` bands, turned by the azimuth (Habel et al. 2008, eq. 4).
    static void TurnSums(ReadOnlySpan<Real> factors, ReadOnlySpan<Real> sums, ReadOnlySpan<Real> cosines,
        ReadOnlySpan<Real> sines, int bands, Span<Real> found)
    {
        found.Clear();
        for (int channel = 0; channel < ChannelCount; ++channel)
        {
            int column = 0;
            foreach (int l in Degrees)
            {
                if (l >= bands) break;
                int middle = channel * WeightCount + l * (l + 1), zonal = Mirrored ? column : column + l;
                found[middle] = Mix(factors, sums, channel, zonal);
                for (int m = 1; m <= l; ++m)
                {
                    Real weight = Mix(factors, sums, channel, zonal + m);
                    Real partner = Mirrored ? 0 : Mix(factors, sums, channel, zonal - m);
                    Turn(weight, partner, cosines[m], sines[m], out found[middle + m], out found[middle - m]);
                }
                column = zonal + l + 1;
            }
        }
    }
#if SKYLIGHT_SH_HAS_SURROUNDINGS

    // The scene's surroundings: a linear map, what shines of itself, the ground.
    static void Surround(Span<Real> weights)
    {
        Span<Real> made = stackalloc Real[WeightCount];
        for (int channel = 0; channel < ChannelCount; ++channel)
        {
            Span<Real> found = weights.Slice(channel * WeightCount, WeightCount);
            found.CopyTo(made);
#if SKYLIGHT_SH_HAS_TRANSFER
            for (int i = 0; i < WeightCount; ++i)
            {
                made[i] = 0;
                for (int j = 0; j < WeightCount; ++j) made[i] += Transfer[i * WeightCount + j] * found[j];
            }
#endif
#if SKYLIGHT_SH_HAS_LIGHTS
            for (int i = 0; i < WeightCount; ++i) made[i] += Own[channel * WeightCount + i];
#endif
#if SKYLIGHT_SH_HAS_GROUND
            Real fallen = made[2];
            for (int i = 0; i < WeightCount; ++i) made[i] += Below[channel * WeightCount + i] * fallen;
#endif
            made.CopyTo(found);
        }
    }
#endif

    // Fills `weights` with the first bands, 1 to Bands, the others 0; returns the status.
    static int Evaluate(ReadOnlySpan<float> inputs, float azimuth, int asked, Span<float> weights)
    {
        if (weights.Length < ChannelCount * WeightCount)
            throw new ArgumentException("Should have ChannelCount * WeightCount places.", nameof(weights));
        weights = weights.Slice(0, ChannelCount * WeightCount);
        Span<Real> x = stackalloc Real[AxisCount], first = stackalloc Real[FirstCount];
        Span<Real> others = stackalloc Real[OtherCount], factors = stackalloc Real[FactorCount];
        Span<Real> sums = stackalloc Real[ClassCount * Width], found = stackalloc Real[ChannelCount * WeightCount];
        Span<Real> cosines = stackalloc Real[Bands], sines = stackalloc Real[Bands];
        weights.Clear();
        int status = ClampInputs(inputs, azimuth, x), bands = Math.Min(Math.Max(asked, 1), Bands);
        if (status == Invalid) return status;
        if (bands != asked) status = Clamped;
#if SKYLIGHT_SH_HAS_SURROUNDINGS
        // All bands: what surrounds the sky carries light from one to another.
        int read = Bands;
#else
        int read = bands;
#endif
        int used = 0;
        foreach (int l in Degrees) used += l >= read ? 0 : Mirrored ? l + 1 : 2 * l + 1;
        FirstFunctions(x, first);
        OtherFunctions(x, others);
        Factors(x, factors);
#if SKYLIGHT_SH_HAS_TWILIGHT
        Real share = FadeOf(inputs[Sun]);
        for (int k = 0; k < FactorCount; ++k) factors[k] *= share;
#endif
        Waves(azimuth, Peak < 0 ? 1 : (Real)Math.Sin(x[Peak]), cosines, sines);
        AddTerms(first, others, used, sums);
        TurnSums(factors, sums, cosines, sines, read, found);
#if SKYLIGHT_SH_HAS_SURROUNDINGS
        Surround(found);
#endif
        for (int channel = 0; channel < ChannelCount; ++channel)
            for (int i = 0; i < bands * bands; ++i)
                weights[channel * WeightCount + i] = (float)found[channel * WeightCount + i];
#if SKYLIGHT_SH_IS_WINDOWED
        // The window follows the number of bands.
        if (bands < Bands)
            for (int l = 1; l < bands; ++l)
                ScaleZonal(weights, l, Sinc((float)l / bands) / Sinc((float)l / Bands));
#endif
        return status;
    }

    // Multiplies the zonal weight of degree l of every channel.
    static void ScaleZonal(Span<float> weights, int l, float factor)
    {
        for (int channel = 0; channel < ChannelCount; ++channel) weights[channel * WeightCount + l * (l + 1)] *= factor;
    }
}
