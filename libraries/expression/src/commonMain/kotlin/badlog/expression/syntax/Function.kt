package badlog.expression.syntax

import badlog.analysis.Span
import badlog.expression.samples.Column
import badlog.expression.samples.Folding
import badlog.expression.samples.Operation
import badlog.expression.samples.Scalar
import badlog.expression.samples.Value
import badlog.expression.samples.all
import badlog.expression.samples.any
import badlog.expression.samples.area
import badlog.expression.samples.changed
import badlog.expression.samples.chosen
import badlog.expression.samples.clamped
import badlog.expression.samples.combined
import badlog.expression.samples.count
import badlog.expression.samples.delta
import badlog.expression.samples.derivative
import badlog.expression.samples.duration
import badlog.expression.samples.during
import badlog.expression.samples.first
import badlog.expression.samples.hold
import badlog.expression.samples.last
import badlog.expression.samples.maximum
import badlog.expression.samples.mean
import badlog.expression.samples.minimum
import badlog.expression.samples.missing
import badlog.expression.samples.percentile
import badlog.expression.samples.previous
import badlog.expression.samples.shifted
import badlog.expression.samples.standardDeviation
import badlog.expression.samples.total
import badlog.expression.samples.wholeIntegral
import badlog.expression.samples.windowed
import badlog.expression.syntax.Parameter.CONDITION
import badlog.expression.syntax.Parameter.NUMBERS
import badlog.expression.syntax.Parameter.NUMBERS_OR_CONDITION
import badlog.expression.syntax.Parameter.ONE_NUMBER
import badlog.expression.syntax.Parameter.SHARE
import badlog.expression.syntax.Parameter.SHIFT
import badlog.expression.syntax.Parameter.VARYING
import badlog.expression.syntax.Parameter.VARYING_CONDITION
import badlog.expression.syntax.Parameter.VARYING_NUMBERS
import badlog.expression.syntax.Parameter.WINDOW
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.asin
import kotlin.math.atan
import kotlin.math.atan2
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.log10
import kotlin.math.round
import kotlin.math.sign
import kotlin.math.sin
import kotlin.math.sqrt
import kotlin.math.tan

/**
 * What can be called.
 *
 * @property title how it is written; several with one title differ in how many operands they take.
 */
internal enum class Function(
    val title: String,
    val parameters: List<Parameter>,
    val result: Result,
    val movesTimes: Boolean = false,
    val compute: Computation,
) {
    MIN("min", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).minimum() }),
    MAX("max", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).maximum() }),
    MEAN("mean", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).mean() }),
    MEDIAN("median", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).percentile(50.0) }),
    PERCENTILE("percentile", listOf(VARYING_NUMBERS, SHARE), Result.NUMBER, compute = { it.column(0).percentile(it.number(1)) }),
    STDDEV("stddev", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).standardDeviation() }),
    FIRST("first", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).first() }),
    LAST("last", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).last() }),
    INTEGRAL("integral", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).wholeIntegral() }),
    DURATION("duration", listOf(VARYING), Result.NUMBER, compute = { it.column(0).duration() }),
    COUNT("count", listOf(VARYING), Result.NUMBER, compute = { it.column(0).count(it.isCondition(0), it.range) }),
    TIME_OF_MIN("time_of_min", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).minimum().timeAlone() }),
    TIME_OF_MAX("time_of_max", listOf(VARYING_NUMBERS), Result.NUMBER, compute = { it.column(0).maximum().timeAlone() }),
    ANY("any", listOf(VARYING_CONDITION), Result.CONDITION, compute = { it.column(0).any(it.range) }),
    ALL("all", listOf(VARYING_CONDITION), Result.CONDITION, compute = { it.column(0).all() }),
    TOTAL("total", listOf(VARYING_CONDITION), Result.NUMBER, compute = { it.column(0).total(it.range) }),

    WINDOW_MIN(
        "min",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        compute = { it.column(0).windowed(it.number(1), Folding.MIN) },
    ),
    WINDOW_MAX(
        "max",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        compute = { it.column(0).windowed(it.number(1), Folding.MAX) },
    ),
    WINDOW_MEAN(
        "mean",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        compute = { it.column(0).windowed(it.number(1), Folding.MEAN) },
    ),
    DELTA("delta", listOf(VARYING_NUMBERS), Result.NUMBERS, compute = { it.column(0).delta() }),
    DERIVATIVE("derivative", listOf(VARYING_NUMBERS), Result.NUMBERS, compute = { it.column(0).derivative() }),
    AREA("area", listOf(VARYING_NUMBERS), Result.NUMBERS, compute = { it.column(0).area() }),
    PREVIOUS("previous", listOf(VARYING), Result.AS_FIRST, compute = { it.column(0).previous() }),
    HOLD("hold", listOf(VARYING), Result.AS_FIRST, compute = { it.column(0).hold() }),
    SHIFT_TIME(
        "shift",
        listOf(VARYING, SHIFT),
        Result.AS_FIRST,
        movesTimes = true,
        compute = { it.column(0).shifted(it.number(1)) },
    ),
    CHANGED("changed", listOf(VARYING), Result.CONDITIONS, compute = { it.column(0).changed() }),
    MISSING("missing", listOf(VARYING), Result.CONDITIONS, compute = { it.column(0).missing() }),
    DURING(
        "during",
        listOf(ONE_NUMBER, ONE_NUMBER),
        Result.CONDITIONS,
        movesTimes = true,
        compute = { during(it.number(0), it.number(1), it.range) },
    ),

    IF("if", listOf(CONDITION, NUMBERS_OR_CONDITION, NUMBERS_OR_CONDITION), Result.AS_CHOSEN, compute = { it.chosen() }),
    CLAMP("clamp", listOf(NUMBERS, NUMBERS, NUMBERS), Result.ELEMENTWISE, compute = { it.clamped() }),
    ATAN2("atan2", listOf(NUMBERS, NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { y, x -> atan2(y, x) } }),
    ABS("abs", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> abs(x) } }),
    SIGN("sign", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> sign(x) } }),
    SQRT("sqrt", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> sqrt(x) } }),
    EXP("exp", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> exp(x) } }),
    LOG("log", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> ln(x) } }),
    LOG10("log10", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> log10(x) } }),
    SIN("sin", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> sin(x) } }),
    COS("cos", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> cos(x) } }),
    TAN("tan", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> tan(x) } }),
    ASIN("asin", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> asin(x) } }),
    ACOS("acos", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> acos(x) } }),
    ATAN("atan", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> atan(x) } }),
    FLOOR("floor", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> floor(x) } }),
    CEIL("ceil", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> ceil(x) } }),
    ROUND("round", listOf(NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { x, _ -> round(x) } }),
    ;

    /** Computes the result of one call. */
    fun interface Computation {
        fun of(arguments: Arguments): Value
    }

    /** What a function gives. */
    enum class Result {
        NUMBER,
        CONDITION,
        NUMBERS,
        CONDITIONS,

        /** What its first operand is. */
        AS_FIRST,

        /** What its second and third operand are; over time when one of the operands is. */
        AS_CHOSEN,

        /** A number, over time when one of its operands is. */
        ELEMENTWISE,
    }

    companion object {
        private val byTitle = entries.groupBy { it.title }

        /** Those that are called [name], in any case; empty without one. */
        fun called(name: String): List<Function> = byTitle[name.lowercase()].orEmpty()
    }
}

/** What a function takes, and how an error says what is needed. */
internal enum class Parameter(val needed: String) {
    VARYING("something that changes over time"),
    VARYING_NUMBERS("numbers that change over time"),
    VARYING_CONDITION("a condition that changes over time, such as x > 0"),
    NUMBERS("a number"),
    CONDITION("a condition, such as x > 0"),

    /** A number or a condition. */
    NUMBERS_OR_CONDITION("a number or a condition"),
    ONE_NUMBER("one number for the whole log"),
    WINDOW("a time above 0 with its unit, such as 1 s"),
    SHIFT("a time with its unit, such as 0.1 s"),
    SHARE("a number from 0 to 100"),
    ;

    /** Whether [node], whose type is known, will do. */
    fun accepts(node: Node): Boolean {
        val type = node.type
        return when (this) {
            VARYING -> type.isOverTime
            VARYING_NUMBERS -> type.isOverTime && type.kind.isNumeric
            VARYING_CONDITION -> type.isOverTime && type.kind == Kind.CONDITION
            NUMBERS, NUMBERS_OR_CONDITION -> type.kind.isNumeric
            CONDITION -> type.kind == Kind.CONDITION
            ONE_NUMBER -> !type.isOverTime && type.kind.isNumeric
            WINDOW -> node is Node.Time && node.seconds > 0
            SHIFT -> node is Node.Time
            SHARE -> node is Node.Number && node.value in 0.0..100.0
        }
    }
}

/**
 * What a function is called with.
 *
 * @property range of the whole recording.
 */
internal class Arguments(private val values: List<Value>, private val areConditions: List<Boolean>, val range: Span?) {
    fun column(index: Int): Column = values[index] as Column

    fun number(index: Int): Double = (values[index] as Scalar).value

    fun isCondition(index: Int): Boolean = areConditions[index]

    fun chosen(): Value = chosen(values[0], values[1], values[2])

    fun clamped(): Value = clamped(values[0], values[1], values[2])

    /** Of the one operand, or of both. */
    fun elementwise(operation: Operation): Value = combined(values[0], values.getOrNull(1) ?: Scalar(Double.NaN), operation)
}
