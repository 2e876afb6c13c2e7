package badlog.wpilog

/** The columns that one record, or one element of an array, fills, all at the same times. */
internal class SampleBlock(val columns: List<SampleColumn>, clock: Clock) {
    /** The times of the columns. */
    var clock: Clock = clock
        private set
    private var isInGap = false

    /** Says that a sample comes at [time]; to be told whether the block goes with [shared], which is moved on by its owner. */
    fun meet(time: Double, shared: Clock) {
        isInGap = false
        if (clock !== shared) clock.add(time)
    }

    /** Says that the array has lost this element at [time]: a gap, from which on the block has a clock of its own. */
    fun miss(time: Double, shared: Clock) {
        if (isInGap) return
        isInGap = true
        if (clock === shared) clock = shared.copy()
        clock.add(time)
        for (column in columns) column.addGap()
    }
}
