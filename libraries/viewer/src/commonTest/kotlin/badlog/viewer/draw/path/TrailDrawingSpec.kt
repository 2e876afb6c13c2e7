package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.signals.pose.Trail
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Strokes
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

private const val WIDTH = 20
private const val HEIGHT = 12

class TrailDrawingSpec : FunSpec({
    val plane = Plane(Span(0.0, WIDTH.toDouble()), Span(0.0, HEIGHT.toDouble()))
    val place = Arb.choice(
        Arb.pair(Arb.numericDouble(-3.0, 23.0), Arb.numericDouble(-3.0, 15.0)),
        Arb.pair(Arb.int(0..19).map { it + 0.5 }, Arb.constant(5.5)),
        Arb.constant(Double.NaN to 1.0),
        Arb.constant(1e300 to -1e300),
        Arb.constant(Double.POSITIVE_INFINITY to 0.0),
    )

    fun drawn(places: List<Pair<Double, Double>>, isJoined: Boolean): Strokes {
        val trail = Trail(DoubleArray(places.size) { it.toDouble() }, DoubleArray(places.size) { places[it].first }, DoubleArray(places.size) { places[it].second })
        val strokes = Strokes()
        TrailDrawing(TrailPyramid(trail)).draw(0, places.size, plane.xScale(WIDTH.toDouble()), plane.yScale(HEIGHT.toDouble()), WIDTH, HEIGHT, isJoined, strokes)
        return strokes
    }

    /** The distance of ([x], [y]) from everything that was drawn. */
    fun Strokes.distanceTo(x: Double, y: Double): Double {
        var least = Double.POSITIVE_INFINITY
        for (i in 0 until dotsSize step 2) least = minOf(least, sqrt((dots[i] - x) * (dots[i] - x) + (dots[i + 1] - y) * (dots[i + 1] - y)))
        for (stroke in 0 until count) {
            for (i in startOf(stroke) until endOf(stroke) - 2 step 2) {
                val right = points[i + 2] - points[i]
                val down = points[i + 3] - points[i + 1]
                val length = right * right + down * down
                val share = if (length == 0.0) 0.0 else (((x - points[i]) * right + (y - points[i + 1]) * down) / length).coerceIn(0.0, 1.0)
                val dx = points[i] + share * right - x
                val dy = points[i + 1] + share * down - y
                least = minOf(least, sqrt(dx * dx + dy * dy))
            }
        }
        return least
    }

    test("a path that covers most of a picture is dense, with thin lines, and one of a few strokes is not") {
        fun isDense(samples: Int): Boolean {
            val times = DoubleArray(samples) { it.toDouble() }
            val trail = Trail(times, DoubleArray(samples) { 10 + 9.5 * sin(it * 0.0137) }, DoubleArray(samples) { 6 + 5.5 * cos(it * 0.0191) })
            val strokes = Strokes()
            TrailDrawing(TrailPyramid(trail)).draw(0, samples, plane.xScale(1000.0), plane.yScale(600.0), 1000, 600, true, strokes)
            return strokes.isDense
        }
        isDense(200_000) shouldBe true
        isDense(2_000) shouldBe false
    }

    test("no pixel with a sample is lost, and no more is drawn than there are pixels") {
        checkAll(Arb.list(place, 0..400), Arb.boolean()) { places, isJoined ->
            val strokes = drawn(places, isJoined)
            for ((x, y) in places) {
                if (x.isNaN() || x !in 0.0..19.99 || y !in 0.01..12.0) continue
                (strokes.distanceTo(x, HEIGHT - y) <= 1.5).shouldBeTrue()
            }
            val pixels = (WIDTH + 2) * (HEIGHT + 2)
            (0 until strokes.count).sumOf { (strokes.endOf(it) - strokes.startOf(it)) / 2 - 1 } shouldBeLessThanOrEqual pixels
            strokes.dotsSize / 2 shouldBeLessThanOrEqual pixels
        }
    }

    test("samples are drawn in their order") {
        checkAll(Arb.list(place, 0..200)) { places ->
            val strokes = drawn(places, isJoined = true)
            val samples = places.map { (x, y) -> plane.xScale(WIDTH.toDouble()).placeOf(x) to plane.yScale(HEIGHT.toDouble()).placeOf(y) }
            var at = 0
            for (stroke in 0 until strokes.count) {
                var i = strokes.startOf(stroke)
                // A stroke may begin again where the one before ended.
                at = maxOf(0, at - 1)
                while (i < strokes.endOf(stroke)) {
                    while (samples[at].first != strokes.points[i] || samples[at].second != strokes.points[i + 1]) at++
                    i += 2
                }
            }
        }
    }

    test("a million samples around a circle are one circle of pixels") {
        val count = 1_000_000
        val trail = Trail(
            DoubleArray(count) { it.toDouble() },
            DoubleArray(count) { 10 + 5 * cos(it / 1000.0) },
            DoubleArray(count) { 6 + 5 * sin(it / 1000.0) },
        )
        val strokes = Strokes()
        TrailDrawing(TrailPyramid(trail)).draw(0, count, plane.xScale(WIDTH.toDouble()), plane.yScale(HEIGHT.toDouble()), WIDTH, HEIGHT, true, strokes)
        (0 until strokes.count).sumOf { (strokes.endOf(it) - strokes.startOf(it)) / 2 } shouldBeLessThanOrEqual 60
    }

    test("samples at one place are a dot, at two places a line") {
        drawn(List(9) { 3.2 to 4.2 }, isJoined = true).run { count to dotsSize } shouldBe (0 to 2)
        drawn(listOf(1.0 to 1.0, 8.0 to 9.0), isJoined = true).run { abs(points[0] - points[2]) to count } shouldBe (7.0 to 1)
    }
})
