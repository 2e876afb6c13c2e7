package badlog.formats

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.LogView
import badlog.core.analysis.ModeTopics
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.recording.ProblemKind
import badlog.core.recording.Topic
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.doubles
import badlog.formats.wpilog.number
import badlog.formats.wpilog.parseLog
import badlog.formats.wpilog.text
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs

private fun TestLog.view() = LogView.of(parseLog(bytes))

private fun LogView.topic(name: String): Topic = recording.topics.single { it.name == name }

private fun LogView.points(name: String) = seriesOf(topic(name)).data.run { x.toList().zip(y.toList()) }

class OwnTimesSpec : FunSpec({
    test("x is time in s, from the first sample of any topic to the last of any") {
        val view = TestLog().start(1, "a", "double").start(2, "b", "double")
            .double(1, 3_000_000, 1.0).double(2, 1_000_000, 1.0).double(2, 2_000_000, 1.0).view()
        view.xAxis.title shouldBe "Time (s)"
        view.xAxis.isIndex shouldBe false
        view.xAxis.range shouldBe 1.0..3.0
        view.xAxis.clocks.map { it.toList() } shouldBe listOf(listOf(3.0), listOf(1.0, 2.0))
        TestLog().view().xAxis.range shouldBe null
    }

    test("a series is the topic's own arrays") {
        val view = TestLog().start(1, "a", "double").double(1, 1_000_000, 5.0).double(1, 2_000_000, 6.0).view()
        val series = view.seriesOf(view.topic("a")).data
        series.x shouldBeSameInstanceAs view.topic("a").times
        series.y shouldBeSameInstanceAs view.topic("a").samples
    }

    test("states, truth values and events are at the topic's own times") {
        val log = TestLog().start(1, "mode", "string").start(2, "on", "boolean").start(3, "messages", "string")
            .string(1, 1_000_000, "auto").string(1, 2_000_000, "teleop").string(1, 4_000_000, "auto")
            .record(2, 3_000_000, byteArrayOf(1)).string(3, 2_500_000, "hello").string(3, 2_600_000, "hello")
        val view = log.view()
        view.points("mode") shouldBe listOf(1.0 to 0.0, 2.0 to 1.0, 4.0 to 0.0)
        view.points("on") shouldBe listOf(3.0 to 1.0)
        view.seriesOf(view.topic("on")).states shouldBe listOf("false", "true")
        val events = view.folders.flatMap { it.eventLogs }.single().events
        events.map { it.x to it.text } shouldBe listOf(2.5 to "hello", 2.6 to "hello")
        view.folders.flatMap { it.graphs }.map { it.name } shouldBe listOf("mode", "on")
    }

    test("a missing array element is a gap until it comes back") {
        val view = TestLog().start(1, "names", "string[]")
            .record(1, 1_000_000, number(1, 4) + text("a")).record(1, 2_000_000, number(0, 4))
            .record(1, 3_000_000, number(1, 4) + text("a")).view()
        view.points("names[0]").map { (x, y) -> x to y.takeUnless(Double::isNaN) } shouldBe
            listOf(1.0 to 0.0, 2.0 to null, 3.0 to 0.0)
    }

    test("attributes derive topics as in a log of rows, and the attribute for an x axis is reported") {
        val view = TestLog().start(1, "a", "double", "{\"unit\":\"m\",\"attrs\":[\"differentiate\",\"xaxis\"]}")
            .double(1, 0, 1.0).double(1, 2_000_000, 5.0).view()
        val derived = view.folders.flatMap { it.graphs }.single { it.isVirtual }
        derived.unit shouldBe "m/s"
        derived.series.single().data.run { x.toList().zip(y.toList()) } shouldBe listOf(1.0 to 2.0)
        view.problems.map { it.kind } shouldContain ProblemKind.UNFIT_ATTRIBUTE
        view.xAxis.topic shouldBe null
    }

    test("the last state of enabled holds until the recording's end") {
        val view = TestLog().start(1, "DS:enabled", "boolean").start(2, "DS:autonomous", "boolean").start(3, "x", "double")
            .record(1, 0, byteArrayOf(0)).record(1, 1_000_000, byteArrayOf(1))
            .record(2, 500_000, byteArrayOf(1)).record(2, 3_000_000, byteArrayOf(0)).double(3, 9_000_000, 1.0).view()
        val modes = ModeTopics(FlagTopic("DS:enabled", FlagReading.Truth), FlagTopic("DS:autonomous", FlagReading.Truth))
        view.identified(null, modes).enabledSpans() shouldBe listOf(EnabledSpan(Span(1.0, 3.0), true), EnabledSpan(Span(3.0, 9.0), false))
    }

    test("writing a recording without rows as a bag is refused as the caller's mistake") {
        val recording = parseLog(TestLog().start(1, "a", "double[]").record(1, 1, doubles(1.0)).bytes)
        val refused = runCatching { badlog.core.bag.RecordingWriter(recording).write { _, _ -> } }
        (refused.exceptionOrNull() is IllegalArgumentException) shouldBe true
        recording.problems.shouldBeEmpty()
    }
})
