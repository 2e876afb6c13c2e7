package badlog.page

import badlog.core.bag.BagTopic
import java.nio.file.Path
import kotlin.io.path.appendBytes
import kotlin.io.path.writeBytes

/** A robot that writes rows at 50 Hz into [file]. The first topic is the row number, the second is the battery's voltage. */
internal class WritingRobot(val file: Path, motors: Int = 4) {
    private val topics = listOf(TIME, BagTopic("Count", "ul"), BagTopic("Battery Voltage", "V"), BagTopic("Enabled", "ul")) +
        List(motors) { BagTopic("Motor ${it + 1}/Current", "A") }
    var rows = 0
        private set
    var volts = 12.4

    init {
        file.writeBytes(bagOf(topics, 0) { _, _ -> null })
    }

    fun write(count: Int) {
        val header = bagOf(topics, 0) { _, _ -> null }.size
        val bytes = bagOf(topics, count) { row, column ->
            when (column) {
                0 -> (rows + row) / 50.0
                1 -> rows + row
                2 -> volts
                3 -> 1
                else -> ((rows + row) * 7 + column * 13) % 40 / 3.0
            }
        }
        file.appendBytes(bytes.copyOfRange(header, bytes.size))
        rows += count
    }
}
