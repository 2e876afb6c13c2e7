package badlog.samples.generated.log

import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.recording.Value

/** Writes a bag: one row per loop. Topics must be numbers or truth values. */
internal class BagRecorder(private val topics: List<LoggedTopic>, values: List<Value>) : Recorder {
    private val rows = RowWriter()
    private val held = arrayOfNulls<Any>(topics.size)
    private var loops = 0

    init {
        rows.header(BagHeader(topics.map { BagTopic(it.name, it.unit, it.attributes) }, values.map { BagValue(it) }))
    }

    override fun loop(time: Double) {
        for ((index, topic) in topics.withIndex()) {
            if (loops % topic.everyLoops == 0) held[index] = topic.read()
            when (val value = held[index]) {
                null -> rows.empty()
                is Boolean -> rows.number(if (value) 1.0 else 0.0)
                else -> if ("xaxis" in topic.attributes) rows.microseconds(time) else rows.number(value as Double)
            }
        }
        rows.endRow()
        loops++
    }

    override fun frame(time: Double) = Unit

    override fun bytes(): ByteArray = rows.bytes.copyOf(rows.size)
}
