using System;
using Real = System.Single;

public static partial class SkylightSh
{
    // The packed table's terms, unpacked once, before the first evaluation.
    static class Unpacked
    {
        internal static readonly byte[] Lengths = new byte[ClassCount * OtherCount];
        internal static readonly Real[] Rows;

        // How many bits of the stream are read.
        static int at;

        static Unpacked()
        {
            var all = new Real[Lengths.Length * FirstCount * Width];
            Decode(all);
            int terms = 0, end = 0;
            foreach (byte length in Lengths) terms += length;
            Rows = new Real[terms * Width];
            for (int run = 0; run < Lengths.Length; ++run)
            {
                Array.Copy(all, run * FirstCount * Width, Rows, end, Lengths[run] * Width);
                end += Lengths[run] * Width;
            }
        }

        // Reads the stream: `all` holds a row for every function of the first axis of every run.
        static void Decode(Real[] all)
        {
            var profile = new int[32];
            var known = new int[Lengths.Length];
            int column = 0;
            for (int l = 0; l < Bands; ++l)
            {
                int used = Fixed(5);
                for (int i = 0; i < used; ++i) profile[i] = Fixed(5);
                for (int m = Mirrored ? 0 : -l; m <= l; ++m, ++column)
                    for (int run = 0; run < Lengths.Length; ++run)
                    {
                        int k = run / OtherCount, other = run % OtherCount;
                        if (other >= RunProfile.Length) continue;
                        known[run] += Rice(0);
                        Lengths[run] = (byte)Math.Max(Lengths[run], known[run]);
                        int level = RunProfile[other] + ClassProfile[k], row = run * FirstCount;
                        for (int i = 0; i < known[run]; ++i, ++row)
                            all[row * Width + column] = Rice(Math.Max(profile[i] + level, 0) >> 1) * Step;
                    }
            }
        }

        // Low bit of each byte first.
        static int Bit()
        {
            int bit = Stream[at >> 3] >> (at & 7) & 1;
            ++at;
            return bit;
        }

        static int Fixed(int size)
        {
            int value = 0;
            for (int i = 0; i < size; ++i) value |= Bit() << i;
            return value;
        }

        // Ones, a zero, `low` low bits; then folded back: 0, 1, 2, 3 -> 0, -1, 1, -2.
        static int Rice(int low)
        {
            int high = 0;
            while (Bit() != 0) ++high;
            int folded = high << low | Fixed(low);
            return (folded & 1) != 0 ? -(folded >> 1) - 1 : folded >> 1;
        }
    }
}
