package badlog.expression

import badlog.expression.samples.Column
import badlog.expression.samples.Scalar
import badlog.expression.samples.Value
import badlog.expression.signals.SampleBounds
import badlog.expression.syntax.Node
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.math.abs
import kotlin.random.Random

class EvaluationSpec : FunSpec({
    test("random expressions give the slow evaluator's results, at the same times") {
        var roundings = 0
        repeat(ROUNDS) { seed ->
            val random = Random(seed)
            val signals = randomSignals(random)
            val text = RandomExpressions(random).any()
            val expression = parsed(text, signals.vocabulary)
            val slow = SlowEvaluator(signals).valueOf(expression.root)
            val fast = Evaluation(signals, expression.root.id + 1).valueOf(expression.root)
            if (isSame(fast, slow)) return@repeat
            val isRounding = (1..3).any { !isSame(slow, SlowEvaluator(signals, Noise.of(seed * 3 + it)).valueOf(expression.root)) }
            if (!isRounding) throw AssertionError("seed $seed: $text is ${shown(fast)}, not ${shown(slow)}")
            roundings++
        }
        // Rounding does not explain more differences.
        roundings shouldBeLessThanOrEqual MAX_ROUNDINGS
    }

    test("printed random expressions are read back unchanged") {
        repeat(ROUNDS) { seed ->
            val random = Random(seed)
            val vocabulary = randomSignals(random).vocabulary
            val expression = parsed(RandomExpressions(random).any(), vocabulary)
            val again = parsed(expression.toString(), vocabulary)
            again.toString() shouldBe expression.toString()
            shape(again.root) shouldBe shape(expression.root)
        }
    }

    test("random expressions have an answer over random samples") {
        repeat(ROUNDS) { seed ->
            val random = Random(seed)
            val signals = randomSignals(random)
            val expression = parsed(RandomExpressions(random).any(), signals.vocabulary)
            val answer = expression.answer(signals)
            (answer.outcome == Outcome.NO_QUESTION) shouldBe !expression.type.isCondition
            if (expression.type.isOverTime && expression.type.isCondition) answer.matches shouldBe answer.spans.isNotEmpty()
            if (signals.series("A").isOrdered) answer.spans.zipWithNext().all { (a, b) -> a.to <= b.from } shouldBe true
            answer.toString().isNotEmpty() shouldBe true
            expression.answerIfHolds(signals)?.toString() shouldBe answer.takeIf { it.matches }?.toString()
            val mayHold = expression.mayHold { name -> SampleBounds(signals.series(name).y) }
            if (answer.matches && !mayHold) throw AssertionError("seed $seed: $expression holds, though it may not")
        }
    }
})

private val ROUNDS = 8 * PropertyTesting.defaultIterationCount
private const val MAX_ROUNDINGS = 8

private fun isSame(fast: Value, slow: SlowValue): Boolean = when (fast) {
    is Scalar -> isSame(fast.value, slow.single)

    is Column -> {
        val rows = slow.rows!!
        fast.size == rows.size && rows.indices.all { isSame(fast.time(it), slow.logged(it)) && isSame(fast.y[it], rows[it].value) }
    }
}

private fun isSame(one: SlowValue, other: SlowValue): Boolean = if (one.rows == null || other.rows == null) {
    isSame(one.single, other.single)
} else {
    one.rows.size == other.rows.size &&
        one.rows.indices.all { isSame(one.logged(it), other.logged(it)) && isSame(one.rows[it].value, other.rows[it].value) }
}

private fun isSame(one: Any?, other: Any?): Boolean = one == other || isSame(number(one) ?: Double.NaN, other)

private fun isSame(fast: Double, slow: Any?): Boolean = when (slow) {
    null -> fast.isNaN()
    is Boolean -> fast == if (slow) 1.0 else 0.0
    is Double -> if (slow.isFinite()) abs(fast - slow) <= 1e-9 * maxOf(1.0, abs(slow)) else fast.compareTo(slow) == 0
    else -> false
}

private fun SlowValue.logged(index: Int) = rows!![index].time.let { course?.logged(it) ?: it }

private fun shown(value: Value): String = when (value) {
    is Scalar -> "${value.value}"
    is Column -> value.x.indices.joinToString { "${value.time(it)}: ${value.y[it]}" }
}

private fun shown(value: SlowValue): String = value.rows?.indices?.joinToString { "${value.logged(it)}: ${value.rows[it].value}" } ?: "${value.single}"

/** The structure of [node], without positions in the text. */
internal fun shape(node: Node): String = when (node) {
    is Node.Number -> "${node.value}"
    is Node.Time -> "${node.seconds}s"
    is Node.Truth -> "${node.value}"
    is Node.Text -> "'${node.text}'"
    is Node.Topic -> node.signal.name
    is Node.Measured -> "${node.value}${node.unit}"
    is Node.Axis -> "time"
    is Node.Enabled -> node.mode.word
    is Node.Negative -> "neg"
    is Node.Not -> "not"
    is Node.For -> "for"
    is Node.Binary -> node.operator.symbol
    is Node.Call -> node.function.name
}.let { if (node.children.isEmpty()) it else node.children.joinToString(" ", "($it ", ")") { child -> shape(child) } }
