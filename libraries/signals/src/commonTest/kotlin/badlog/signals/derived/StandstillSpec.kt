package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.math.abs

class StandstillSpec : FunSpec({
    val times = timesFor(60)
    val pushes = times.of { 0.4 * swing(it) }

    /** Where these pushes move something. */
    fun place(time: Double) = swing(time - 1)
    val frozen = times.of { place(minOf(it, 41.0)) }

    fun most(places: DoubleArray, outputs: DoubleArray = pushes, from: Double = 0.0, to: Double = 60.0) = standstill(times, places, outputs, times.always()).most(from, to)

    test("a part that moved with its motor, and later stands still both ways, is found from then on") {
        most(frozen, to = 41.0) shouldBe 0.0
        most(frozen, from = 49.0) shouldBe 1.0
    }

    test("a part that moves again no longer stands still; one that jumps was only not read") {
        val places = times.of { if (it in 31.0..51.0) 0.0 else place(it) }
        most(places, from = 41.0, to = 50.0) shouldBe 1.0
        most(places, from = 53.0) shouldBe 0.0
        most(times.of { if (it in 31.0..52.0) 0.0 else place(it) }) shouldBe 0.0
    }

    test("a part that few pushes moved before has to stand still for longer") {
        val slow = times.of { 0.4 * swing(it, 8.0) }
        val places = times.of { swing(minOf(it, 18.0) - 2, 8.0) }
        most(places, slow, to = 19.9) shouldBe 0.0
        most(places, slow, from = 21.0) shouldBe 1.0
        most(times.of { if (it in 18.0..30.0) 0.0 else swing(it - 2, 8.0) }, slow) shouldBe 0.0
    }

    test("a part at an end of its range has to stand still for longer, too") {
        most(times.of { if (it in 40.0..48.0) place(40.0) else place(it) }) shouldBe 0.0
        most(times.of { place(minOf(it, 40.0)) }) shouldBe 1.0
    }

    test("a part that rests at a stop is pushed one way only") {
        most(frozen, times.of { if (it < 41) 0.4 * swing(it) else 0.4 }) shouldBe 0.0
    }

    test("a place that its motor never moved belongs to something else") {
        most(times.of { 2.0 }) shouldBe 0.0
        // A pivot that moves now and then, and rollers on it that run all the time.
        most(times.of { (it - 20).coerceIn(0.0, 4.0) }) shouldBe 0.0
    }

    test("rollers that turn while their arm goes out and back do not move it") {
        fun time(it: Double) = if (it in 41.0..49.0) 1.0 else it % 4
        val places = times.of { minOf(time(it) / 0.4, 1.0, maxOf(0.0, (2 - time(it)) / 0.4)) }
        val rollers = times.of {
            if (it in 45.0..49.0) {
                -0.7
            } else if (time(it) < 2.2) {
                0.7
            } else {
                0.0
            }
        }
        most(places, rollers) shouldBe 0.0
    }

    test("play between gears is no movement, and a part that is held up is not pushed") {
        most(times.of { if (it < 41) place(it) else 0.003 * swing(it) }, from = 49.0) shouldBe 1.0
        most(frozen, times.of { (if (it < 41) 0.4 else 0.2) * swing(it) }) shouldBe 0.0
    }

    test("a motor without current pushes nothing, unless its current was never read") {
        most(frozen, powered(pushes, times.of { if (it < 41) 20 * abs(swing(it)) else 0.0 })) shouldBe 0.0
        most(frozen, powered(pushes, times.of { 0.0 })) shouldBe 1.0
    }

    test("a part moved by hand while its motor rests does not stand still") {
        val outputs = times.of { if (it < 40 || it % 4 < 2) 0.4 * swing(it, 4.0) else 0.0 }
        most(times.of { if (it < 40) place(it) else (it / 4).toInt() * 0.1 }, outputs) shouldBe 0.0
    }
})
