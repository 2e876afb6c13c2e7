package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlin.math.abs

class BusRolesSpec : FunSpec({
    val times = timesFor(60)

    /** Sides of a robot that drives back and forth, and sometimes turns. */
    fun side(sign: Int) = times.of { 50 * swing(it) + sign * 8 * swing(it, 7.0) }
    val roller = times.of { if (it % 9 < 4) 80.0 else 0.0 }

    fun roles(speeds: List<DoubleArray>, encoded: List<Int> = emptyList()) = BusRoles(speeds, speeds.map { DoubleArray(0) }, speeds.indices.map { it in encoded })

    test("motors that turn in one ratio are on one shaft, and the first represents all") {
        val follower = DoubleArray(times.size) { -2 * side(1)[it] }
        roles(listOf(side(1), follower, roller)).leaders shouldContainExactly listOf(0, 2)
    }

    test("two pairs that turn alike, and against each other, are the sides of a tank drive") {
        val found = roles(listOf(side(1), side(1), side(-1), side(-1), roller))
        found.drive shouldContainExactly listOf(0, 2)
        found.mechanisms shouldContainExactly listOf(4)
    }

    test("sides that hardly turn against each other are a drive if they go back and forth") {
        fun rare(sign: Int) = times.of { 50 * swing(it) + sign * if (it in 20.0..20.1) 60.0 else 0.0 }
        roles(listOf(rare(1), rare(1), rare(-1), rare(-1), roller)).drive shouldContainExactly listOf(0, 2)
    }

    test("rollers that run alike are not a drive, and without a drive no mechanisms are known") {
        val other = times.of { if (it % 9 < 4) 82 + swing(it) else 0.0 }
        val found = roles(listOf(roller, roller, other, other))
        found.drive.shouldBeEmpty()
        found.mechanisms.shouldBeEmpty()
    }

    test("four motors that run alike drive a swerve, not the four that have absolute encoders") {
        fun wheel(at: Int) = times.of { abs(50 * swing(it)) + 8 * at * swing(it, 1.3) }
        fun steer(at: Int) = times.of { 60 * swing(it, 3.1) + 8 * at * swing(it, 1.7) }
        val found = roles(List(4) { wheel(it) } + List(4) { steer(it) } + listOf(roller), encoded = listOf(4, 5, 6, 7))
        found.drive shouldContainExactly listOf(0, 1, 2, 3)
        found.steering.toSet() shouldBe setOf(4, 5, 6, 7)
        found.mechanisms shouldContainExactly listOf(8)
    }
})
