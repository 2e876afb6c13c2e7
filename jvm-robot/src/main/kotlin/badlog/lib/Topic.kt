package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter

/**
 * One column. A row is made in three steps: [sample] asks the robot's code, without any lock held, because that code
 * may do what it likes; [commit] makes all samples the current ones at once, and [write] writes those, both under the
 * log's lock.
 */
internal abstract class Topic(val description: BagTopic) {
    val name: String get() = description.name

    /** Whether it is the x of all other topics and so needs more digits than they. */
    val isXAxis: Boolean = "xaxis" in description.attributes

    /** Whether it was said that this topic leaves gaps. Saying it twice, when two threads race, does no harm. */
    @Volatile
    var isFaultSaid: Boolean = false

    abstract fun sample()

    abstract fun commit()

    abstract fun write(row: RowWriter)
}
