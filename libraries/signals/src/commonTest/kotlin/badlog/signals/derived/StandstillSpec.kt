package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class StandstillSpec : FunSpec({
    val times = timesFor(60)
    val pushes = times.of { 0.4 * swing(it) }

    fun most(places: DoubleArray, outputs: DoubleArray = pushes, from: Double = 0.0, to: Double = 60.0) = standstill(times, places, outputs, times.always()).most(from, to)

    test("what moved with its motor, and stands still both ways later, is found from then on") {
        val places = times.of { swing(minOf(it, 40.0), 3.1) }
        most(places, to = 39.0) shouldBe 0.0
        most(places, from = 48.0) shouldBe 1.0
    }

    test("a part that moves again is not standing still any more") {
        val places = times.of { if (it in 30.0..50.0) 0.2 else swing(it, 3.1) }
        most(places, from = 40.0, to = 49.0) shouldBe 1.0
        most(places, from = 52.0) shouldBe 0.0
    }

    test("a part that few pushes moved before has to stand still for longer") {
        val slow = times.of { 0.4 * swing(it, 8.0) }
        val places = times.of { swing(minOf(it, 18.0), 6.1) }
        most(places, slow, to = 19.9) shouldBe 0.0
        most(places, slow, from = 20.0) shouldBe 1.0
        most(times.of { if (it in 18.0..30.0) swing(18.0, 6.1) else swing(it, 6.1) }, slow) shouldBe 0.0
    }

    test("a part that rests at a stop is pushed one way only") {
        most(times.of { swing(minOf(it, 40.0), 3.1) }, times.of { if (it < 40) 0.4 * swing(it) else 0.4 }) shouldBe 0.0
    }

    test("a place that its motor never moved belongs to something else") {
        most(times.of { 2.0 }) shouldBe 0.0
        // A pivot that moves now and then, and rollers on it that run all the time.
        most(
            times.of {
                if (it in 20.0..24.0) {
                    it - 20
                } else if (it < 20) {
                    0.0
                } else {
                    4.0
                }
            },
        ) shouldBe 0.0
    }

    test("play between gears is no movement, and a part that is held gently is not pushed") {
        most(times.of { if (it < 40) swing(it, 3.1) else swing(40.0, 3.1) + 0.003 * swing(it) }, from = 48.0) shouldBe 1.0
        most(times.of { swing(minOf(it, 40.0), 3.1) }, times.of { (if (it < 40) 0.4 else 0.1) * swing(it) }) shouldBe 0.0
    }

    test("what somebody moves by hand while its motor rests is not still") {
        val outputs = times.of { if (it < 40 || it % 4 < 2) 0.4 * swing(it, 4.0) else 0.0 }
        most(times.of { if (it < 40) swing(it, 3.1) else (it / 4).toInt() * 0.1 }, outputs) shouldBe 0.0
    }
})
