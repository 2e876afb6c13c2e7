package badlog.signals

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun axisOf(csv: String): String? {
    val recording = BagParser().apply { accept(csv.encodeToByteArray()) }.finish()
    return LogView.of(recording.overItsTime()).xAxis.topic?.name
}

class TimeColumnSpec : FunSpec({
    test("plain CSV is drawn over its rising column of time, even behind other columns") {
        axisOf("A,Time\n5,0\n6,0.02\n7,0.04\n") shouldBe "Time"
        axisOf("Robot/Timestamp (ms),A\n0,1\n20,2\n") shouldBe "Robot/Timestamp (ms)"
    }

    test("a column that falls, has gaps or is constant is not the time, and neither is a time of something else") {
        axisOf("Time,A\n0,1\n2,1\n1,1\n") shouldBe null
        axisOf("Time,A\n0,1\n,1\n1,1\n") shouldBe null
        axisOf("Time,A\n3,1\n3,2\n") shouldBe null
        axisOf("Loop Time,A\n1,1\n2,2\n") shouldBe null
    }

    test("a time may fall in one row of a hundred, because clocks are set") {
        fun rows(falling: Int) = (0 until 200).joinToString("") { "${if (it in 50 until 50 + falling * 2 && it % 2 == 1) 9 else it},1\n" }
        axisOf("Time,A\n${rows(falling = 2)}") shouldBe "Time"
        axisOf("Time,A\n${rows(falling = 3)}") shouldBe null
    }

    test("a bag without an x axis may have such a column, too, but is drawn over it only on request") {
        val header = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[]}],\"values\":[]}\n"
        axisOf("${header}Time\n0\n1\n") shouldBe null
        val bag = BagParser().apply { accept("${header}Time\n0\n1\n".encodeToByteArray()) }.finish()
        val column = checkNotNull(bag.timeColumn())
        LogView.of(bag.over(column)).xAxis.title shouldBe "Time (s)"
        bag.over(column).timeColumn() shouldBe null
    }

    test("a log that names its x axis keeps it") {
        val header = "{\"topics\":[{\"name\":\"X\",\"unit\":\"m\",\"attrs\":[\"xaxis\"]},{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[]}],\"values\":[]}\n"
        axisOf("${header}X,Time\n0,1\n1,2\n") shouldBe "X"
    }
})
