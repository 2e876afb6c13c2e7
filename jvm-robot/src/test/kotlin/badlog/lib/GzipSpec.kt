package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import java.io.File
import java.util.zip.GZIPInputStream

class GzipSpec : FunSpec({
    test("a closed bag is a gzip file like any other") {
        inFolder { folder ->
            for (flush in listOf(true, false)) {
                val file = File(folder, "closed.bag")
                var count = 0.0
                BadLog.init(file.path, true, flush).use { log ->
                    BadLog.createTopic("Count", "ul", { count++ })
                    log.finishInitialization()
                    repeat(2000) { log.row() }
                }
                val bytes = GZIPInputStream(File(folder, "closed.bag.gz").inputStream()).use { it.readBytes() }
                val recording = recordingIn(bytes)
                recording.problems.shouldBeEmpty()
                recording.topics.single().samples.toList() shouldBe List(2000) { it.toDouble() }
            }
        }
    }

    test("a bag without a row is a gzip file, too") {
        inFolder { folder ->
            BadLog.init(File(folder, "empty.bag").path, true).close()
            GZIPInputStream(File(folder, "empty.bag.gz").inputStream()).use { it.readBytes() }.size shouldBe 0
        }
    }

    test("a bag cut anywhere opens with all rows flushed before the cut") {
        inFolder { folder ->
            val file = File(folder, "cut.bag.gz")
            val lengths = ArrayList<Int>()
            var count = 0.0
            BadLog.init(file.path.removeSuffix(".gz"), true, true).use { log ->
                BadLog.createTopic("Count", "ul", { count++ })
                BadLog.createTopic("Sine", "ul", { Math.sin(count) })
                log.finishInitialization()
                lengths.add(file.length().toInt())
                repeat(60) {
                    log.row()
                    lengths.add(file.length().toInt())
                }
            }
            val bytes = file.readBytes()
            for (cut in lengths[0]..bytes.size) {
                val rows = lengths.count { it <= cut } - 1
                val recording = recordingIn(inflated(bytes.copyOf(cut)))
                recording.isReadable shouldBe true
                recording.topics[0].samples.take(rows) shouldBe List(rows) { it.toDouble() }
            }
        }
    }
})
