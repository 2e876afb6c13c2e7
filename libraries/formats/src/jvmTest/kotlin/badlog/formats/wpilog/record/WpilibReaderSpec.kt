package badlog.formats.wpilog.record

import badlog.core.analysis.Span
import badlog.core.bag.VARIED_BAG
import badlog.core.bag.parse
import badlog.core.python.TestPython
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.formats.wpilog.REAL_LOGS
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.doubles
import badlog.formats.wpilog.longs
import badlog.formats.wpilog.number
import badlog.formats.wpilog.parseLog
import badlog.formats.wpilog.text
import badlog.formats.wpilog.writeLog
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.file.Files
import kotlin.math.roundToLong

private val PYTHON = TestPython("wpiutil.log", "robotpy-wpiutil")

/** The lines that WPILib's reader, the one in robotpy, prints about a log. */
private fun linesOf(bytes: ByteArray): List<List<String>> {
    val file = Files.createTempFile("badlog", ".wpilog")
    try {
        Files.write(file, bytes)
        val process = PYTHON.running("src/jvmTest/python/read_wpilog.py", file.toString())
        val lines = process.inputStream.bufferedReader().readLines().map { it.split('\t') }
        process.waitFor() shouldBe 0
        return lines
    } finally {
        Files.delete(file)
    }
}

private fun Topic.texts(): Map<Int, String> = List(texts.size) { texts.rows[it] to texts[it] }.toMap()

private fun hex(text: String) = text.encodeToByteArray().joinToString("") { "%02x".format(it) }

/** Whether [topic] has no value at [index], but had one before. */
private fun beginsGap(topic: Topic, index: Int): Boolean {
    val before = topic.samples.take(index)
    return !topic.isSparse && before.isNotEmpty() && !before.last().isNaN()
}

/** The value as the script prints it; null if there is none. */
private fun valueOf(topic: Topic, texts: Map<Int, String>, index: Int, type: String): Any? {
    val number = topic.samples.getOrElse(index) { Double.NaN }
    return when (type) {
        "string", "json", "structschema" -> texts[index]?.let(::hex)
        "boolean" -> if (number.isNaN()) null else (number != 0.0).toString()
        "int64" -> if (number.isNaN()) null else number.toLong().toString()
        else -> if (number.isNaN() && topic.counts.empty > 0 && !beginsGap(topic, index)) null else number
    }
}

private fun shouldBeRead(recording: Recording, positions: (Topic) -> DoubleArray) {
    val lines = linesOf(writeLog(recording).first)
    val types = lines.filter { it[0] == "start" }.associate { it[1] to it[2] }
    val found = lines.filter { it[0] == "data" }.groupBy { it[1] }
    for (value in recording.values) found.getValue(value.name).single()[4] shouldBe hex(value.text)
    for (topic in recording.topics) {
        val type = types.getValue(topic.name)
        val texts = topic.texts()
        val expected = (0 until topic.size).mapNotNull { index ->
            valueOf(topic, texts, index, type)?.let { (positions(topic)[index] * 1e6).roundToLong().toString() to it }
        }
        val isNumber = type == "double" || type == "float"
        found[topic.name].orEmpty().map { it[3] to if (isNumber) parseHex(it[4]) else it[4] } shouldBe expected
    }
}

private fun parseHex(text: String): Double = when (text) {
    "nan" -> Double.NaN
    "inf" -> Double.POSITIVE_INFINITY
    "-inf" -> Double.NEGATIVE_INFINITY
    else -> java.lang.Double.parseDouble(text)
}

@Tags("InCheck")
class WpilibReaderSpec : FunSpec({
    test("WPILib's reader finds every value of a bag").config(enabledOrReasonIf = PYTHON.isHere) {
        val bag = parse(VARIED_BAG)
        val time = bag.topics.single { it.name == "Time" }
        shouldBeRead(bag) { time.samples }
    }

    test("WPILib's reader finds every value of a log").config(enabledOrReasonIf = PYTHON.isHere) {
        val log = parseLog(VARIED_LOG.bytes)
        log.topics.any { it.kind == TopicKind.BOOLEAN } shouldBe true
        shouldBeRead(log) { checkNotNull(it.times) }
    }

    test("WPILib's reader finds every value of a season's logs, if they are present").config(enabledOrReasonIf = PYTHON.isHere) {
        for (file in REAL_LOGS) shouldBeRead(parseLog(file.readBytes())) { checkNotNull(it.times) }
    }

    test("WPILib's reader finds in a part the records of the whole log, of any type").config(enabledOrReasonIf = PYTHON.isHere) {
        val log = TestLog().start(1, "/Pose", "struct:Pose2d", "{}").start(2, "Ticks", "int64").start(3, "Photo", "raw").start(4, "Names", "string[]")
        for (at in 1L..5L) {
            log.record(1, at * 1_000_000, doubles(at / 2.0)).record(2, at * 1_000_000 + 1, longs(9_007_199_254_740_993 + at))
        }
        log.record(3, 1_500_000, byteArrayOf(1, 2)).record(4, 2_500_000, number(1, 4) + text("a"))
        val part = linesOf(written { RecordCopy(recordsOf(log.bytes), sink = it).spans(listOf(Span(2.0, 4.5)), { false }) })
        val whole = linesOf(log.bytes)
        part.filter { it[0] == "start" } shouldBe whole.filter { it[0] == "start" }
        val inside = whole.filter { it[0] == "data" && it[3].toLong() in 2_000_000L..4_500_000L }
        val held = whole.filter { it[0] == "data" && it[3] in listOf("1000001", "1500000") }.map { it.take(3) + "2000000" + it[4] }
        part.filter { it[0] == "data" }.toSet() shouldBe (inside + held).toSet()
    }

    test("WPILib's reader finds every value of a sample of this project").config(enabledOrReasonIf = PYTHON.isHere) {
        val bag = parse(File("../../samples/practice.bag").readBytes())
        val time = bag.topics.first { "xaxis" in it.attributes }
        shouldBeRead(bag) { time.samples }
    }
})
