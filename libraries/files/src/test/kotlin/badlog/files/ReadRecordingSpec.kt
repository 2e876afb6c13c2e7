package badlog.files

import badlog.core.bag.VARIED_BAG
import badlog.core.bag.VARIED_HEADER
import badlog.core.bag.VARIED_ROWS
import badlog.core.bag.describe
import badlog.core.bag.parse
import badlog.core.recording.NumberSink
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_EVENTS
import badlog.formats.driverstation.STATION_LOG
import badlog.formats.driverstation.parseStation
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.parseLog
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.booleans.shouldBeFalse
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import kotlin.io.path.writeBytes
import kotlin.time.Duration.Companion.minutes

/** Several megabytes. */
private val LARGE = VARIED_HEADER + "0.020000,-1.2346e+05,\"armed, ready\",false\n".repeat(150_000)

/** Pipes among files. */
private val IF_PIPES =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows has no pipes among files")

@Tags("InCheck")
class ReadRecordingSpec : FunSpec({
    fun fileOf(folder: Path, bytes: ByteArray) = folder.resolve("log").also { it.writeBytes(bytes) }

    test("a plain and a compressed file read the same, whatever their names") {
        inFolder { folder ->
            for (text in listOf(VARIED_BAG, LARGE, "a,b\n1,2\n", "", "\n")) {
                val expected = describe(parse(text))
                describe(readRecording(fileOf(folder, text.encodeToByteArray()), LOG_FORMATS)) shouldBe expected
                describe(readRecording(fileOf(folder, gzip(text.encodeToByteArray())), LOG_FORMATS)) shouldBe expected
            }
        }
    }

    test("a large file on one core, and a small one in any case, is read without other threads") {
        inFolder { folder ->
            val small = VARIED_HEADER + "0.020000,-1.2346e+05,\"armed, ready\",false\n".repeat(20_000)
            for ((text, cores) in listOf(LARGE to 1, small to 2)) {
                for (content in listOf(text.encodeToByteArray(), gzip(text.encodeToByteArray()))) {
                    val threads = ConcurrentHashMap.newKeySet<Thread>()
                    val sinks = NumberSinks { _, _ -> NumberSink { _, _ -> threads += Thread.currentThread() } }
                    readRecording(fileOf(folder, content), LOG_FORMATS, ReadOptions(sinks = sinks, cores = cores))
                    threads shouldBe setOf(Thread.currentThread())
                }
            }
        }
    }

    test("counts alone can be read while the numbers go elsewhere, on any number of cores") {
        inFolder { folder ->
            var sum = 0.0
            val sinks = NumberSinks { name, _ -> if (name == parse(LARGE).topics[0].name) NumberSink { _, number -> sum += number } else null }
            val recording = readRecording(fileOf(folder, LARGE.encodeToByteArray()), LOG_FORMATS, ReadOptions(keepSamples = false, sinks = sinks, cores = 3))
            recording.rowCount shouldBe 150_000
            sum shouldBe (3000.0 plusOrMinus 0.001)
        }
    }

    test("samples are kept only if they are requested") {
        inFolder { folder ->
            val topic = readRecording(fileOf(folder, VARIED_BAG.encodeToByteArray()), LOG_FORMATS, ReadOptions(keepSamples = false)).topics[0]
            topic.samples.size shouldBe 0
            topic.counts.numbers shouldBe VARIED_ROWS.size
        }
    }

    test("of a file that is still being written, the whole lines are read without a problem") {
        inFolder { folder ->
            for (size in 1..VARIED_BAG.length) {
                val beginning = VARIED_BAG.encodeToByteArray().copyOf(size)
                val lines = beginning.copyOf(beginning.indexOfLast { it == '\n'.code.toByte() } + 1)
                val recording = readRecording(fileOf(folder, beginning), LOG_FORMATS, ReadOptions(untilLastLineEnd = true))
                describe(recording) shouldBe describe(parse(lines))
            }
            val large = LARGE + "0.020000,-1.23"
            readRecording(fileOf(folder, large.encodeToByteArray()), LOG_FORMATS, ReadOptions(untilLastLineEnd = true)).run {
                rowCount shouldBe 150_000
                isSalvaged.shouldBeFalse()
            }
        }
    }

    test("a last line end is found far before the end, and a carriage return is one") {
        inFolder { folder ->
            val text = "a,b\r1,2\r" + "3".repeat(1_000_000)
            readRecording(fileOf(folder, text.encodeToByteArray()), LOG_FORMATS, ReadOptions(untilLastLineEnd = true)).run {
                rowCount shouldBe 1
                isSalvaged.shouldBeFalse()
            }
        }
    }

    test("a cut compressed file is reported before all else, and all that can be inflated is kept") {
        inFolder { folder ->
            val whole = gzip(LARGE.encodeToByteArray())
            readRecording(fileOf(folder, whole.copyOf(whole.size / 2)), LOG_FORMATS).run {
                problems[0].kind shouldBe ProblemKind.GZIP_CUT
                problems[0].message shouldContain "cut off or damaged; the "
                rowCount shouldBeInRange 10_000..149_999
            }
        }
    }

    test("the end of a compressed file is only a hint of its size") {
        inFolder { folder ->
            val text = LARGE.encodeToByteArray()
            for (size in listOf(0, 1 shl 20, -1)) {
                val trailer = ByteArray(4) { (size shr 8 * it).toByte() }
                val gzip = gzip(text).let { it.copyOf(it.size - 4) + trailer }
                readRecording(fileOf(folder, gzip), LOG_FORMATS).rowCount shouldBe 150_000
            }
        }
    }

    test("progress is reported about once a megabyte, and at the end, in bytes of the file") {
        inFolder { folder ->
            val bytes = LARGE.encodeToByteArray()
            for (content in listOf(bytes, gzip(bytes))) {
                val reported = ArrayList<Long>()
                readRecording(fileOf(folder, content), LOG_FORMATS) { done, total ->
                    total shouldBe content.size
                    reported += done
                }
                reported.shouldBeSorted()
                reported.last() shouldBe content.size
                reported.size shouldBe (content.size + (1 shl 20) - 1) / (1 shl 20)
            }
        }
    }

    test("an exception from the progress is passed on unchanged") {
        inFolder { folder ->
            val bytes = LARGE.encodeToByteArray()
            for (content in listOf(bytes, gzip(bytes))) {
                val thrown = IOException("enough")
                val file = fileOf(folder, content)
                shouldThrow<IOException> { readRecording(file, LOG_FORMATS) { _, _ -> throw thrown } } shouldBe thrown
            }
        }
    }

    test("an interrupted thread stops reading") {
        inFolder { folder ->
            val bytes = LARGE.encodeToByteArray()
            for (content in listOf(bytes, gzip(bytes))) {
                val file = fileOf(folder, content)
                Thread.currentThread().interrupt()
                shouldThrow<InterruptedException> { readRecording(file, LOG_FORMATS) }
                Thread.interrupted().shouldBeFalse()
            }
        }
    }

    test("a file that cannot be read is reported in one sentence") {
        inFolder { folder ->
            val missing = folder.resolve("missing.bag")
            shouldThrow<UnreadableFileException> { readRecording(missing, LOG_FORMATS) }.run {
                file shouldBe missing
                message shouldContain "There is no file or folder $missing"
            }
            shouldThrow<UnreadableFileException> { readRecording(folder, LOG_FORMATS) }.message shouldContain "is a folder"
        }
    }

    test("a pipe is refused without waiting for it").config(timeout = 2.minutes, enabledOrReasonIf = { IF_PIPES }) {
        inFolder { folder ->
            val pipe = folder.resolve("pipe")
            ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() shouldBe 0
            shouldThrow<UnreadableFileException> { readRecording(pipe, LOG_FORMATS) }.message shouldContain "not a regular file"
        }
    }

    test("an empty file is an empty recording") {
        inFolder { folder ->
            val file = fileOf(folder, ByteArray(0))
            for (recording in listOf(readRecording(file, LOG_FORMATS), readRecording(file, LOG_FORMATS, ReadOptions(untilLastLineEnd = true)))) {
                recording.topics.shouldBeEmpty()
                recording.problems.map { it.kind } shouldContain ProblemKind.EMPTY_FILE
            }
        }
    }

    test("a WPILOG, plain or compressed, reads as its bytes do") {
        inFolder { folder ->
            val expected = describeLog(parseLog(VARIED_LOG.bytes))
            describeLog(readRecording(fileOf(folder, VARIED_LOG.bytes), LOG_FORMATS)) shouldBe expected
            describeLog(readRecording(fileOf(folder, gzip(VARIED_LOG.bytes)), LOG_FORMATS)) shouldBe expected
            val cut = readRecording(fileOf(folder, gzip(VARIED_LOG.bytes).let { it.copyOf(it.size - 30) }), LOG_FORMATS)
            cut.problems.first().kind shouldBe ProblemKind.GZIP_CUT
        }
    }

    test("of a WPILOG that is still being written, the whole records are read and the half one is not a problem") {
        inFolder { folder ->
            val bytes = VARIED_LOG.bytes
            for (cut in 1..20) {
                val beginning = bytes.copyOf(bytes.size - cut)
                val kinds = readRecording(fileOf(folder, beginning), LOG_FORMATS, ReadOptions(untilLastLineEnd = true)).problems.map { it.kind }
                kinds shouldBe parseLog(beginning).problems.map { it.kind } - ProblemKind.RECORD_CUT
            }
        }
    }

    test("a .dslog is read with the .dsevents of the same name beside it, compressed or not, otherwise alone") {
        inFolder { folder ->
            val log = folder.resolve("2026_03_07 10_04_05 Sat.dslog")
            Files.write(log, STATION_LOG.bytes)
            describeLog(readRecording(log, LOG_FORMATS)) shouldBe describeLog(parseStation(STATION_LOG.bytes))
            val events = Files.write(folder.resolve("2026_03_07 10_04_05 Sat.dsevents"), STATION_EVENTS.bytes)
            val pair = describeLog(parseStation(STATION_LOG.bytes + STATION_EVENTS.bytes))
            describeLog(readRecording(log, LOG_FORMATS)) shouldBe pair
            describeLog(readRecording(events, LOG_FORMATS)) shouldBe describeLog(parseStation(STATION_EVENTS.bytes))
            val packed = Files.write(folder.resolve("a.dslog.gz"), gzip(STATION_LOG.bytes))
            Files.write(folder.resolve("a.dsevents.gz"), gzip(STATION_EVENTS.bytes))
            describeLog(readRecording(packed, LOG_FORMATS)) shouldBe pair
        }
    }

    test("real logs, if present, are read from the disk as from their bytes") {
        val logs = File(System.getenv("BADLOG_REAL_LOGS").orEmpty()).listFiles { file -> file.name.endsWith(".wpilog") }.orEmpty()
        for (log in logs) describeLog(readRecording(log.toPath(), LOG_FORMATS)) shouldBe describeLog(parseLog(log.readBytes()))
    }
})
