package badlog.viewer.shown.cursor

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.signals.pose.lastAtOrBefore
import badlog.viewer.bagView
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class SampleAtCursorSpec : FunSpec({
    fun LogView.line(name: String) = seriesOf(recording.topics.single { it.name == name })
    fun LogView.textAt(name: String, x: Double) = line(name).let { it.textOf(it.indexAt(x)) { number -> number.toInt().toString() } }

    val rows = bagView(listOf("Time|xaxis", "A", "Mode", "On"), listOf("0,1,auto,true", "1,,teleop,false", "2,3,teleop,false"))

    test("a state that was logged row by row is read from the last row, however near the next one is") {
        rows.textAt("Mode", 0.9) shouldBe "auto"
        rows.textAt("Mode", 0.0) shouldBe "auto"
        rows.textAt("Mode", 2.0) shouldBe "teleop"
        rows.textAt("Mode", -1.0) shouldBe "–"
        rows.textAt("On", 0.9) shouldBe "true"
        rows.textAt("On", 1.0) shouldBe "false"
    }

    test("a number that was measured row by row is read from the nearest sample with the dot, and a gap is a dash") {
        rows.textAt("A", 0.4) shouldBe "1"
        rows.textAt("A", 0.5) shouldBe "1"
        rows.textAt("A", 0.6) shouldBe "–"
        rows.textAt("A", 1.6) shouldBe "3"
        rows.line("A").dotAt(1.6) shouldBe 2.0
        rows.line("A").indexAt(Double.NaN) shouldBe -1
    }

    test("a number with times of its own lasts until the next one, and so does its dot") {
        val line = timedView(timedTopic("A", 0.0 to 1.0, 5.0 to 3.0)).line("A")
        line.indexAt(4.9) shouldBe 0
        line.dotAt(4.9) shouldBe 4.9
        line.indexAt(5.0) shouldBe 1
        line.indexAt(-1.0) shouldBe -1
        line.dotAt(-1.0).isNaN() shouldBe true
    }

    test("at the end of a log of changes, each line has its last value, however old, and after the log none") {
        val log = timedView(timedTopic("A", 0.0 to 1.0, 5.0 to 3.0), timedTopic("B", 0.0 to 7.0, 1.0 to 8.0))
        log.textAt("A", 5.0) shouldBe "3"
        log.textAt("B", 5.0) shouldBe "8"
        log.textAt("B", 5.1) shouldBe "–"
        log.line("B").dotAt(5.1).isNaN() shouldBe true
    }

    test("before and after a log of rows, no line has a value, however near its first or last sample is") {
        for (x in listOf(-0.1, 2.1)) for (name in listOf("A", "Mode", "On")) rows.textAt(name, x) shouldBe "–"
        rows.textAt("A", 2.0) shouldBe "3"
    }

    test("the only sample of a log is read everywhere in the visible range around it") {
        val one = bagView(listOf("Time|xaxis", "A"), listOf("4,1"))
        one.textAt("A", 4.3) shouldBe "1"
        one.textAt("A", 4.6) shouldBe "–"
    }

    test("the last sample at or before a place is found in any order of x") {
        checkAll(Arb.list(Arb.numericDouble(-5.0, 5.0), 0..20), Arb.double(-6.0, 6.0)) { places, position ->
            for (x in listOf(places, places.sorted())) {
                val series = Series(x.toDoubleArray(), DoubleArray(x.size))
                series.lastAtOrBefore(position) shouldBe x.indexOfLast { it <= position }
            }
        }
    }
})
