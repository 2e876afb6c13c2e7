package badlog.rules.number

import badlog.signals.match.MatchKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs

class FigureTextSpec : FunSpec({
    val keys = listOf(FigureKey("loop time", "A/Loop; Time", Measure.ENABLED, "ms"), FigureKey("battery", "B", Measure.LOWEST, "V"))
    val figures = LogFigures(MatchKind.MATCH, keys, doubleArrayOf(12.5, -1e-7), 0.25)

    test("figures come back as they were, and equal names are read once") {
        val reader = FigureReader()
        val (one, other) = List(2) { reader.read(figures.toText()) }
        one.kind shouldBe MatchKind.MATCH
        one.keys shouldBe keys
        one.values.toList() shouldBe listOf(12.5, -1e-7)
        one.uncertainty shouldBe 0.25
        other.keys shouldBeSameInstanceAs one.keys
    }

    test("how a log begins and ends comes back, also of one that is too short for figures") {
        val short = LogFigures(MatchKind.MATCH, emptyList(), DoubleArray(0), Double.NaN, beginsEnabled = true)
        FigureReader().read(short.toText()).run { listOf(beginsEnabled, endsEnabled) } shouldBe listOf(true, false)
        val long = LogFigures(MatchKind.MATCH, keys, doubleArrayOf(1.0, 2.0), 0.25, endsEnabled = true)
        FigureReader().read(long.toText()).run { listOf(beginsEnabled, endsEnabled) } shouldBe listOf(false, true)
    }

    test("none is none, and so is any other text") {
        val reader = FigureReader()
        val texts = listOf(LogFigures.NONE.toText(), FigureText("x", "1;2;3"), FigureText(figures.toText().names, "9;;false;false;1;2"), FigureText("", ""))
        texts.map { reader.read(it).keys.size } shouldBe listOf(0, 0, 0, 0)
    }
})
