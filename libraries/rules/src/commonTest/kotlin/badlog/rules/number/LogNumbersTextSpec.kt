package badlog.rules.number

import badlog.signals.match.MatchKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs

class LogNumbersTextSpec : FunSpec({
    val keys = listOf(NumberKey("loop time", "A/Loop; Time", Measure.ENABLED, "ms"), NumberKey("battery", "B", Measure.LOWEST, "V"))
    val numbers = LogNumbers(MatchKind.MATCH, keys, doubleArrayOf(12.5, -1e-7), 0.25)

    test("numbers are read as they were written, and equal names are parsed once") {
        val reader = LogNumbersReader()
        val (one, other) = List(2) { reader.read(numbers.toText()) }
        one.kind shouldBe MatchKind.MATCH
        one.keys shouldBe keys
        one.values.toList() shouldBe listOf(12.5, -1e-7)
        one.uncertainty shouldBe 0.25
        other.keys shouldBeSameInstanceAs one.keys
    }

    test("the start and end of a log are read as they were written, also for one too short for numbers") {
        val short = LogNumbers(MatchKind.MATCH, emptyList(), DoubleArray(0), Double.NaN, beginsEnabled = true)
        LogNumbersReader().read(short.toText()).run { listOf(beginsEnabled, endsEnabled) } shouldBe listOf(true, false)
        val long = LogNumbers(MatchKind.MATCH, keys, doubleArrayOf(1.0, 2.0), 0.25, endsEnabled = true)
        LogNumbersReader().read(long.toText()).run { listOf(beginsEnabled, endsEnabled) } shouldBe listOf(false, true)
    }

    test("an empty list of numbers stays empty, and any other text has no numbers") {
        val reader = LogNumbersReader()
        val texts = listOf(LogNumbers.NONE.toText(), LogNumbersText("x", "1;2;3"), LogNumbersText(numbers.toText().names, "9;;false;false;1;2"), LogNumbersText("", ""))
        texts.map { reader.read(it).keys.size } shouldBe listOf(0, 0, 0, 0)
    }
})
