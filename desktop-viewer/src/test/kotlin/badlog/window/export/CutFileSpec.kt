package badlog.window.export

import badlog.catalog.folder.loggedTopic
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.shown.table.rowsWithin
import badlog.window.graph.withFormulas
import badlog.window.wpilogRecording
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.nio.file.Files

class CutFileSpec : FunSpec({
    val folder = tempdir().toPath()
    val file = folder.resolve("match.bag")
    Files.writeString(file, armBag(500))
    val whole = recordingOf(armBag(500), file)

    test("a part saved as a bag has only its rows, with the values, units and attributes of the whole") {
        val target = folder.resolve("part.bag")
        cutFile(whole, Span(1.0, 2.0), target) shouldBe "Wrote 51 rows to $target."
        val part = readRecording(target, LOG_FORMATS)
        val source = whole.view.recording
        part.values shouldBe source.values + Value("Part", "1 s to 2 s")
        part.problems.shouldBeEmpty()
        part.topics.forEachIndexed { i, topic ->
            topic.name shouldBe source.topics[i].name
            topic.unit shouldBe source.topics[i].unit
            topic.attributes shouldBe source.topics[i].attributes
            topic.samples.toList() shouldBe source.topics[i].samples.drop(50).take(51)
        }
        val mode = source.topics.last().texts
        part.topics.last().texts.let { texts -> List(texts.size) { texts[it] } } shouldBe (50..100).map { mode[it] }
    }

    test("a part of a WPILOG has rows every 20 ms, or at the samples of a denser topic, with the last values") {
        val open = wpilogRecording(
            loggedTopic("Gain", 0.0 to 1.0, 0.05 to 2.0, 2.0 to 5.0),
            loggedTopic("Gyro", *List(200) { 1 + it * 0.005 to it.toDouble() }.toTypedArray()),
        )
        val target = folder.resolve("wpilog part.bag")
        cutFile(open, Span(0.0, 0.1), target) shouldBe
            "Wrote 6 rows to $target, one every 20 ms, each with the last values before it."
        val part = readRecording(target, LOG_FORMATS)
        part.problems.filter { it.severity != Severity.NOTE }.shouldBeEmpty()
        part.topics.single { it.name == "Gain" }.samples.toList() shouldBe listOf(1.0, 1.0, 1.0, 2.0, 2.0, 2.0)
        tableFile(open, CsvDraft.ofAll(open.view, Span(1.0, 1.5)), target) shouldContain "one at each sample of “Gyro”"
        Files.readAllLines(target).size shouldBe 102
        shouldThrow<IOException> { cutFile(open, Span(5.0, 6.0), target) }.message shouldContain "no samples"
    }

    test("formulas are columns of a part; a formula without a value in each row is left out and reported") {
        val target = folder.resolve("formula part.bag")
        val open = whole.withFormulas(listOf("Twice [deg] = 2 * Arm/Angle", "Most = max(Arm/Angle)", "Is Far = Arm/Angle > 10"))
        cutFile(open, Span(0.2, 0.4), target) shouldBe
            "Wrote 11 rows to $target, without “Most”, which does not have a value in each row."
        val part = readRecording(target, LOG_FORMATS)
        part.problems.filter { it.severity != Severity.NOTE }.shouldBeEmpty()
        part.topics.map { it.name } shouldContainExactly listOf("Time", "Arm/Angle", "Arm/Current", "Arm/Mode", "Twice", "Is Far")
        part.topics.single { it.name == "Twice" }.samples.toList() shouldBe List(11) { (it + 10) * 2.0 }
        part.topics.single { it.name == "Twice" }.unit shouldBe "deg"
        part.topics.single { it.name == "Is Far" }.samples.toList() shouldBe List(11) { if (it == 0) 0.0 else 1.0 }
    }

    test("a CSV file of a part begins with titles and units") {
        val target = folder.resolve("part.csv")
        tableFile(whole, CsvDraft.ofAll(whole.view, Span(0.02, 0.04)), target)
        Files.readAllLines(target).first() shouldBe "Time (s),Arm/Angle (deg),Arm/Current (A),Arm/Mode"
        Files.readAllLines(target).size shouldBe 3
    }

    test("the open file is never overwritten, and no other file is left beside it") {
        val failure = shouldThrow<IOException> { cutFile(whole, Span(1.0, 2.0), file) }
        failure.message shouldContain "select another name"
        Files.readString(file) shouldBe armBag(500)
        Files.list(folder).use { all -> all.map { it.fileName.toString() }.filter { "part" !in it }.toList() } shouldContainExactly
            listOf("match.bag")
    }

    test("a part without samples, and a folder that cannot be written, are reported in a sentence") {
        shouldThrow<IOException> { cutFile(whole, Span(2000.0, 2001.0), folder.resolve("none.bag")) }
            .message shouldContain "no samples"
        Files.writeString(folder.resolve("a part file"), "")
        shouldThrow<IOException> { cutFile(whole, Span(0.0, 1.0), folder.resolve("a part file/part.bag")) }
            .message shouldContain "cannot be written"
    }

    test("a part includes the rows between its first and last where x goes backwards") {
        val back = recordingOf("""{"topics":[{"name":"T","unit":"s","attrs":["xaxis"]}],"values":[]}""" + "\nT\n1\n5\n2\n9\n")
        rowsWithin(back.view.xAxis.positions, Span(0.0, 3.0)) shouldBe 0..2
        rowsWithin(back.view.xAxis.positions, Span(6.0, 7.0)).isEmpty() shouldBe true
    }
})
