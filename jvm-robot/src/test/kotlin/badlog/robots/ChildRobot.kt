package badlog.robots

import badlog.lib.BadLog
import badlog.lib.DataInferMode
import java.io.RandomAccessFile
import java.nio.channels.FileChannel

/**
 * A robot program that runs in its own process. It logs to the path in the first argument as many rows as the second says, gzipped if the
 * third is `true`. It writes the number of calls of `log()` that have returned to the file in the fourth. That file is mapped into memory,
 * so that the number is right however the process ends.
 */
object ChildRobot {
    @JvmStatic
    fun main(args: Array<String>) {
        val (path, rows, compress, returned) = args
        val progress = RandomAccessFile(returned, "rw").use { it.channel.map(FileChannel.MapMode.READ_WRITE, 0, 8) }
        val log = BadLog.init(path, compress.toBoolean(), true)
        var row = 0L
        BadLog.createTopicLong("Row", "ul", { row })
        BadLog.createTopicDouble("Sine", "ul", { Math.sin(row.toDouble()) })
        for (i in 1..20) BadLog.createTopic("Topic/$i", "V", { row * 0.1 * i })
        BadLog.createTopicBoolean("Odd", "ul", { row % 2 == 1L })
        val events = BadLog.createEvents("Events")
        val publisher = BadLog.createPublisher("Published", "ul", DataInferMode.LAST)
        BadLog.createValue("Robot", "child")
        log.finishInitialization()
        while (row < rows.toLong()) {
            publisher.publish(row * 0.5)
            if (row % 100 == 7L) events.event("row $row, \"quoted\"")
            log.updateTopics()
            log.log()
            progress.putLong(0, ++row)
        }
    }
}
