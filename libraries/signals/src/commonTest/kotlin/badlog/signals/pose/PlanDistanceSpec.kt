package badlog.signals.pose

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class PlanDistanceSpec : FunSpec({
    fun trail(vararg places: Triple<Double, Double, Double>) = Trail(places.map { it.first }.toDoubleArray(), places.map { it.second }.toDoubleArray(), places.map { it.third }.toDoubleArray())

    fun path(size: Int, y: (Int) -> Double = { 0.0 }, x: (Int) -> Double) = trail(*Array(size) { Triple(it / 10.0, x(it), y(it)) })

    fun distances(driven: Trail, planned: Trail, vararg spans: Span) = planDistance(driven, planned, spans.toList()).y.toList()
    val all = Span(0.0, 100.0)

    test("the distance is taken at the same moment, in whole centimeters") {
        val plan = path(10) { it / 10.0 }
        distances(path(10, y = { it * 0.0304 }) { it / 10.0 }, plan, all) shouldBe List(10) { i -> kotlin.math.round(i * 3.04) / 100 }
    }

    test("outside the spans, and once the plan stands still, no plan is followed") {
        val plan = path(20) { minOf(it, 12) / 10.0 }
        val found = distances(path(20) { it / 10.0 }, plan, Span(0.5, 1.6))
        found.indices.filter { !found[it].isNaN() } shouldBe (5..12).toList()
    }

    test("a goal that jumps is not a plan, and neither is one that stands still") {
        val driven = path(20) { 0.0 }
        distances(driven, path(20) { it / 5 * 2.0 }, all).all { it.isNaN() } shouldBe true
        distances(driven, path(20) { 3.0 }, all).all { it.isNaN() } shouldBe true
    }

    test("a robot that was never on a plan has not left it, and each plan counts by itself") {
        val driven = path(20) { it / 10.0 }
        distances(driven, path(20, y = { 3.0 }) { it / 10.0 }, all).all { it.isNaN() } shouldBe true
        // The second plan begins beside the robot.
        val found = distances(driven, path(20, y = { if (it < 10) 0.0 else 1.0 }) { it / 10.0 }, all)
        found.indices.filter { !found[it].isNaN() } shouldBe (0..9).toList()
    }

    test("gaps of either trail are gaps of the distance") {
        val found = distances(path(4) { if (it == 1) Double.NaN else 0.0 }, path(4) { if (it == 2) Double.NaN else it / 10.0 }, all)
        found.map { it.isNaN() } shouldBe listOf(false, true, true, false)
    }

    test("the path of a log is the pair of poses that shares most folders, and then the one in the fewest") {
        fun pathOf(vararg names: String) = PlannedPath.of(posesOf(names.flatMap { poseTopics(it) }))?.run { driven.name to planned.name }
        pathOf("Auto/Goal", "Vendor/Drive/Deep/Pose", "Drive/Pose", "Drive/Target Pose") shouldBe ("Drive/Pose" to "Drive/Target Pose")
        pathOf("A/B/Pose", "Pose", "Plan") shouldBe ("Pose" to "Plan")
        pathOf("Drive/Pose", "Trajectory[0]").shouldBeNull()
    }
})
