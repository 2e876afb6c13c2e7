package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.signals.pose.Trail
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Strokes
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.sin
import kotlin.random.Random

private const val WIDTH = 300
private const val HEIGHT = 200

class TrailPyramidSpec : FunSpec({
    /** A path that stands, trembles, drives, jumps, gets lost and comes back. */
    fun walk(seed: Int): Trail {
        val random = Random(seed)
        val x = DoubleArray(random.nextInt(700))
        val y = DoubleArray(x.size)
        var atX = 0.5
        var atY = 0.5
        var step = 0.0
        for (i in x.indices) {
            if (random.nextInt(40) == 0) step = listOf(0.0, 1e-5, 1e-3, 0.01, 0.1)[random.nextInt(5)]
            if (random.nextInt(90) == 0) atX = random.nextDouble()
            atX = (atX + step * (random.nextDouble() - 0.4)).coerceIn(-0.5, 1.5)
            atY = (atY + step * (random.nextDouble() - 0.5)).coerceIn(-0.5, 1.5)
            x[i] = if (random.nextInt(150) == 0) Double.NaN else atX
            y[i] = listOf(Double.NaN, Double.POSITIVE_INFINITY, -1e300).getOrElse(random.nextInt(600)) { atY }
        }
        return Trail(DoubleArray(x.size) { it.toDouble() }, x, y)
    }

    /** Adds the pixels on the straight line from one place to another to [pixels]. */
    fun mark(pixels: BooleanArray, fromX: Double, fromY: Double, toX: Double, toY: Double) {
        val count = ceil(maxOf(abs(toX - fromX), abs(toY - fromY), 1.0)).toInt()
        for (i in 0..count) {
            val px = fromX + (toX - fromX) * i / count
            val py = fromY + (toY - fromY) * i / count
            if (px >= 0 && px < WIDTH && py >= 0 && py < HEIGHT) pixels[py.toInt() * WIDTH + px.toInt()] = true
        }
    }

    /** The pixels of every sample from [start] until [end], and of every way between two of them. */
    fun allPixels(trail: Trail, start: Int, end: Int, plane: Plane, isJoined: Boolean): BooleanArray {
        val pixels = BooleanArray(WIDTH * HEIGHT)
        val x = plane.xScale(WIDTH.toDouble())
        val y = plane.yScale(HEIGHT.toDouble())
        for (i in start until end) {
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            if (px.isNaN() || py.isNaN()) continue
            mark(pixels, px, py, px, py)
            if (!isJoined || i == start) continue
            val lastX = x.placeOf(trail.x[i - 1])
            val lastY = y.placeOf(trail.y[i - 1])
            if (!lastX.isNaN() && !lastY.isNaN()) mark(pixels, lastX, lastY, px, py)
        }
        return pixels
    }

    fun pixelsOf(strokes: Strokes): BooleanArray {
        val pixels = BooleanArray(WIDTH * HEIGHT)
        for (i in 0 until strokes.dotsSize step 2) mark(pixels, strokes.dots[i], strokes.dots[i + 1], strokes.dots[i], strokes.dots[i + 1])
        for (stroke in 0 until strokes.count) {
            for (i in strokes.startOf(stroke) until strokes.endOf(stroke) - 2 step 2) {
                mark(pixels, strokes.points[i], strokes.points[i + 1], strokes.points[i + 2], strokes.points[i + 3])
            }
        }
        return pixels
    }

    /** The number of pixels of [one] that are more than a pixel away from all pixels of [other]. */
    fun missing(one: BooleanArray, other: BooleanArray): Int = one.indices.count { i ->
        one[i] && (-1..1).none { down ->
            (-1..1).any { right ->
                val column = i % WIDTH + right
                val row = i / WIDTH + down
                column in 0 until WIDTH && row in 0 until HEIGHT && other[row * WIDTH + column]
            }
        }
    }

    test("skipping blocks and drawing every sample give the same picture, to a pixel, at any zoom and for any time") {
        checkAll(Arb.int(), Arb.boolean()) { seed, isJoined ->
            val trail = walk(seed)
            val drawing = TrailDrawing(TrailPyramid(trail))
            val strokes = Strokes()
            val random = Random(seed)
            for (zoom in listOf(1.0, 0.2, 0.01)) {
                val left = random.nextDouble()
                val bottom = random.nextDouble()
                val plane = if (zoom == 1.0) Plane(Span(-0.6, 1.6), Span(-0.6, 1.6)) else Plane(Span(left, left + zoom), Span(bottom, bottom + zoom))
                val start = random.nextInt(trail.size + 1)
                val end = if (zoom == 0.2) random.nextInt(start, trail.size + 1) else trail.size
                val x = plane.xScale(WIDTH.toDouble())
                drawing.draw(start, end, x, plane.yScale(HEIGHT.toDouble()), WIDTH, HEIGHT, isJoined, strokes)
                val expected = allPixels(trail, start, end, plane, isJoined)
                missing(expected, pixelsOf(strokes)) shouldBe 0
                missing(pixelsOf(strokes), expected) shouldBe 0
            }
        }
    }

    test("a scribble that fills areas is drawn in the same rows of pixels, with fewer strokes than samples") {
        val trail = DoubleArray(150_000) { it.toDouble() }.let { times ->
            Trail(times, DoubleArray(times.size) { 1 + sin(it * 0.0131) }, DoubleArray(times.size) { 1 + cos(it * 0.0173) })
        }
        val plane = Plane(Span(-0.1, 2.1), Span(0.3, 2.1))
        val strokes = Strokes()
        TrailDrawing(TrailPyramid(trail)).draw(0, trail.size, plane.xScale(WIDTH.toDouble()), plane.yScale(HEIGHT.toDouble()), WIDTH, HEIGHT, true, strokes)
        strokes.isDense shouldBe true
        strokes.count shouldBeLessThan 5000
        (0 until strokes.count).all { strokes.points[strokes.startOf(it) + 1] == strokes.points[strokes.startOf(it) + 3] } shouldBe true
        val expected = allPixels(trail, 0, trail.size, plane, isJoined = true)
        missing(expected, pixelsOf(strokes)) shouldBe 0
        missing(pixelsOf(strokes), expected) shouldBe 0
    }

    test("very many dots are drawn as rows of pixels, and fewer ones each at its place") {
        val random = Random(1)
        fun drawn(count: Int): Pair<Strokes, BooleanArray> {
            val trail = DoubleArray(count) { it.toDouble() }.let { times ->
                Trail(times, DoubleArray(count) { 1.2 * random.nextDouble() - 0.1 }, DoubleArray(count) { 0.6 * random.nextDouble() })
            }
            val plane = Plane(Span(0.0, 1.0), Span(0.0, 1.0))
            val strokes = Strokes()
            TrailDrawing(TrailPyramid(trail)).draw(0, count, plane.xScale(WIDTH.toDouble()), plane.yScale(HEIGHT.toDouble()), WIDTH, HEIGHT, false, strokes)
            return strokes to allPixels(trail, 0, count, plane, isJoined = false)
        }
        val (rows, expected) = drawn(100_000)
        rows.isDense shouldBe true
        rows.dotsSize shouldBe 0
        rows.count shouldBeLessThan 10_000
        val pixels = BooleanArray(WIDTH * HEIGHT)
        for (row in 0 until rows.count) {
            val at = rows.startOf(row)
            val y = rows.points[at + 1].toInt() * WIDTH
            val columns = rows.points[at].toInt() until rows.points[at + 2].toInt()
            for (column in columns) pixels[y + column] = true
            expected[y + columns.first] shouldBe true
            expected[y + columns.last] shouldBe true
            // Dots are so wide that the gaps between them are invisible.
            columns.windowed(3).count { gap -> gap.none { expected[y + it] } } shouldBe 0
        }
        expected.indices.filter { expected[it] && !pixels[it] }.shouldBeEmpty()

        val (dots, _) = drawn(10_000)
        dots.isDense shouldBe false
        dots.count shouldBe 0
        dots.dotsSize / 2 shouldBe dots.dots.take(dots.dotsSize).chunked(2) { (x, y) -> floor(x) to floor(y) }.toSet().size
    }

    test("without skipping, every sample is visited once and in order, and blocks end at their last sample") {
        checkAll(Arb.int(0..5000), Arb.int(0..5000)) { one, other ->
            val start = minOf(one, other)
            val end = maxOf(one, other)
            val pyramid = TrailPyramid(DoubleArray(5000) { it.toDouble() }.let { Trail(it, it, it) })
            var next = start
            pyramid.visit(start, end, { _, _, _ -> false }, { error("passed over $it") }) { it shouldBe next++ }
            next shouldBe end

            next = start
            var from = start
            pyramid.visit(start, end, { boxes, at, steps ->
                from = next - 1
                boxes.slice(at until at + 4) shouldBe listOf(from, from + steps, from, from + steps).map { it.toDouble() }
                true
            }, { next = it + 1 }) { it shouldBe next++ }
            next shouldBe end
        }
    }

    test("with strides, a line is as near to each sample as required, and skips most of a smooth path") {
        fun most(trail: Trail, bendX: Double, bendY: Double): Int {
            val pyramid = TrailPyramid(trail)
            val visited = ArrayList<Int>()
            pyramid.visit(0, trail.size, { _, _, _ -> false }, {}, { pyramid.strideOf(it, bendX, bendY) }, visited::add)
            visited.lastOrNull() shouldBe (trail.size - 1).takeIf { it >= 0 }
            for ((from, to) in visited.zipWithNext()) {
                for (i in from + 1 until to) {
                    val share = (i - from).toDouble() / (to - from)
                    abs(trail.x[from] + share * (trail.x[to] - trail.x[from]) - trail.x[i]) shouldBeLessThan bendX * 1.000001
                    abs(trail.y[from] + share * (trail.y[to] - trail.y[from]) - trail.y[i]) shouldBeLessThan bendY * 1.000001
                }
            }
            return visited.size
        }
        checkAll(Arb.int()) { seed -> most(walk(seed), 0.004, 0.002) }
        val count = 10_000
        val smooth = Trail(DoubleArray(count) { it.toDouble() }, DoubleArray(count) { 8 + 6 * sin(it / 240.0) }, DoubleArray(count) { 4 + 3 * cos(it / 175.0) })
        most(smooth, 0.005, 0.005) shouldBeLessThan count / 7
        most(smooth, 0.05, 0.05) shouldBeLessThan count / 15
        most(smooth, 1e-9, 1e-9) shouldBe count
    }

    test("a small part of the plane examines few samples of a long path") {
        val count = 1_000_000
        val trail = Trail(
            DoubleArray(count) { it.toDouble() },
            DoubleArray(count) { 8 + 6 * sin(it / 240.0) },
            DoubleArray(count) { 4 + 3 * cos(it / 175.0) },
        )
        var looks = 0
        TrailPyramid(trail).visit(0, count, { boxes, at, _ ->
            looks++
            boxes[at] > 4.2 || boxes[at + 1] < 4 || boxes[at + 2] > 4.2 || boxes[at + 3] < 4
        }, {}) { looks++ }
        looks shouldBeLessThan count / 20
    }

    test("the time of the nearest place is the result of a search of all places") {
        checkAll(Arb.int(), Arb.int(0..700)) { seed, start ->
            val trail = walk(seed)
            val random = Random(seed)
            val x = random.nextDouble()
            val y = random.nextDouble()
            val before = (random.nextDouble() * 700).takeIf { random.nextBoolean() }
            val visible = Span(start.toDouble(), random.nextDouble() * 700)
            fun distance(i: Int) = (trail.x[i] - x) / 0.003 * ((trail.x[i] - x) / 0.003) + (trail.y[i] - y) / 0.005 * ((trail.y[i] - y) / 0.005)
            val near = (trail.startOf(visible) until trail.endOf(visible)).filter { distance(it) <= 20.0 * 20.0 }
            val nearest = near.minByOrNull(::distance)
            val expected = if (before == null || nearest == null) {
                nearest
            } else {
                (listOf(nearest) + near).filter { distance(it) <= distance(nearest) + 9 }.minByOrNull { abs(it - before) }
            }
            val found = timeOfNearest(TrailPyramid(trail), x, y, 0.003, 0.005, reach = 20.0, visible, before)
            found.takeUnless { it.isNaN() } shouldBe expected?.toDouble()
        }
    }
})
