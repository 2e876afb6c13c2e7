package badlog.analysis

/**
 * What a series looks like on a screen of [count] pixel columns, see [Downsampling]. One is made for a screen and filled
 * again for each zoom.
 *
 * @property count how many pixel columns there are.
 */
public class PixelColumns(public val count: Int) {
    /** For each column the value of its first sample; NaN where that is a gap or there is no sample. */
    public val first: DoubleArray = DoubleArray(count)

    /** For each column its smallest finite value, NaN without one. */
    public val min: DoubleArray = DoubleArray(count)

    /** For each column its largest finite value, NaN without one. */
    public val max: DoubleArray = DoubleArray(count)

    /** For each column the value of its last sample; NaN where that is a gap or there is no sample. */
    public val last: DoubleArray = DoubleArray(count)

    /** For each column how many samples it has, gaps included. */
    public val samples: IntArray = IntArray(count)

    /** Whether column [column] begins with a gap, so that no line may lead into it. */
    public fun beginsInGap(column: Int): Boolean = samples[column] > 0 && first[column].isNaN()

    /** Whether column [column] ends with a gap, so that no line may lead out of it. */
    public fun endsInGap(column: Int): Boolean = samples[column] > 0 && last[column].isNaN()

    internal fun clear() {
        first.fill(Double.NaN)
        min.fill(Double.NaN)
        max.fill(Double.NaN)
        last.fill(Double.NaN)
        samples.fill(0)
    }
}
