package badlog.window.log

import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ValueTextSpec : FunSpec({
    test("the cursor reads the nearest number with its unit, the state that lasts, and a dash in a gap, and before and after the log") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A", "Mode", "On"), listOf("0,1.5,auto,true", "1,,teleop,false", "2,0.1,teleop,false")))
        fun text(name: String, x: Double?) = open.signal(name)!!.let { valueText(it, x) }
        text("A", 0.5) shouldBe "1.5 V"
        text("A", 1.0) shouldBe "–"
        text("A", null) shouldBe "0.1 V"
        text("A", 1.6) shouldBe "0.1 V"
        text("A", -1.0) shouldBe "–"
        text("Mode", 0.9) shouldBe "auto"
        text("Mode", -1.0) shouldBe "–"
        text("Mode", 0.0) shouldBe "auto"
        text("Mode", 2.0) shouldBe "teleop"
        text("Mode", 9.0) shouldBe "–"
        text("On", 0.0) shouldBe "true"
    }
})
