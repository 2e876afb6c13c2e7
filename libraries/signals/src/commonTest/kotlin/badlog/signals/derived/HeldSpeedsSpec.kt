package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class HeldSpeedsSpec : FunSpec({
    val times = timesFor(20)

    test("a speed that its output keeps near one value is held there, at each of several levels") {
        val speed = times.of { (if (it < 10) 40.0 else 80.0) + swing(it, 0.7) }
        val held = heldSpeeds(times, speed, times.of { 0.5 + 0.1 * swing(it + 0.35, 0.7) })
        held[250] shouldBe (40.0 plusOrMinus 1.0)
        held[750] shouldBe (80.0 plusOrMinus 1.0)
    }

    test("a speed that follows its output, or has a constant output, is not held") {
        val speed = times.of { 40 + swing(it, 0.7) }
        heldSpeeds(times, speed, times.of { 0.5 + 0.1 * swing(it, 0.7) }).max() shouldBe 0.0
        heldSpeeds(times, speed, times.of { 0.5 }).max() shouldBe 0.0
    }
})
