package badlog.viewer.shown.cursor

import badlog.core.analysis.LogView
import badlog.viewer.bagView
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class CursorValuesSpec : FunSpec({
    fun LogView.values() = CursorValues(recording.topics.map(::seriesOf), xAxis)
    fun LogView.at(x: Double) = values().at(x).map { recording.topics[it.line].name to it.hasChanged }

    test("lines that changed within a tenth of a second are first, by their share of the range, and the rest keeps its order") {
        val view = timedView(
            timedTopic("Still", 0.0 to 1.0, 9.0 to 1.0),
            timedTopic("Later", 0.0 to 1.0, 5.2 to 9.0),
            timedTopic("Some", 0.0 to 0.0, 5.0 to 3.0, 9.0 to 10.0),
            timedTopic("All", 0.0 to 0.0, 5.05 to 3.0, 9.0 to 0.0),
        )
        view.at(5.0) shouldBe listOf("All" to true, "Some" to true, "Still" to false, "Later" to false)
        view.at(5.14) shouldBe listOf("Later" to true, "All" to true, "Still" to false, "Some" to false)
        view.at(2.0).none { it.second } shouldBe true
    }

    test("a changed state is before numbers, and noise is not a change") {
        val rows = List(200) { row -> "${row % 2 + if (row == 150) 900 else 0},$row,${if (row < 100) "auto" else "teleop"}" }
        val view = bagView(listOf("Noise", "Ramp", "Mode"), rows)
        view.at(100.0) shouldBe listOf("Mode" to true, "Ramp" to true, "Noise" to false)
        view.at(50.0) shouldBe listOf("Ramp" to true, "Noise" to false, "Mode" to false)
    }

    test("each line is listed once at any cursor, the changed ones first") {
        val topic = Arb.list(Arb.numericDouble(-5.0, 5.0), 0..6)
        checkAll(Arb.list(topic, 0..6), Arb.int(-2..8)) { topics, x ->
            val view = timedView(*topics.mapIndexed { i, y -> timedTopic("T$i", *y.mapIndexed { at, value -> at.toDouble() to value }.toTypedArray()) }.toTypedArray())
            val values = view.values().at(x.toDouble())
            values.map { it.line } shouldContainExactlyInAnyOrder topics.indices.toList()
            values.map { it.hasChanged } shouldBe values.map { it.hasChanged }.sortedDescending()
        }
    }
})
