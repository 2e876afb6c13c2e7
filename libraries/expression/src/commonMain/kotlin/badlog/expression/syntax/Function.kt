package badlog.expression.syntax

import badlog.expression.samples.Value
import badlog.expression.samples.after
import badlog.expression.samples.all
import badlog.expression.samples.any
import badlog.expression.samples.area
import badlog.expression.samples.before
import badlog.expression.samples.changed
import badlog.expression.samples.count
import badlog.expression.samples.cycleTimes
import badlog.expression.samples.delta
import badlog.expression.samples.derivative
import badlog.expression.samples.duration
import badlog.expression.samples.during
import badlog.expression.samples.falls
import badlog.expression.samples.first
import badlog.expression.samples.firstPart
import badlog.expression.samples.hold
import badlog.expression.samples.last
import badlog.expression.samples.lastPart
import badlog.expression.samples.lengths
import badlog.expression.samples.maximum
import badlog.expression.samples.mean
import badlog.expression.samples.minimum
import badlog.expression.samples.missing
import badlog.expression.samples.numbers
import badlog.expression.samples.percentile
import badlog.expression.samples.previous
import badlog.expression.samples.rises
import badlog.expression.samples.sampleMean
import badlog.expression.samples.samplePercentile
import badlog.expression.samples.sampleStandardDeviation
import badlog.expression.samples.shifted
import badlog.expression.samples.standardDeviation
import badlog.expression.samples.total
import badlog.expression.samples.wholeIntegral
import badlog.expression.samples.windowExtreme
import badlog.expression.samples.windowMean
import badlog.expression.syntax.Parameter.CONDITION
import badlog.expression.syntax.Parameter.NUMBERS
import badlog.expression.syntax.Parameter.NUMBERS_OR_CONDITION
import badlog.expression.syntax.Parameter.ONE_NUMBER
import badlog.expression.syntax.Parameter.SHARE
import badlog.expression.syntax.Parameter.SHIFT
import badlog.expression.syntax.Parameter.TEXT
import badlog.expression.syntax.Parameter.VARYING
import badlog.expression.syntax.Parameter.VARYING_CONDITION
import badlog.expression.syntax.Parameter.VARYING_NUMBERS
import badlog.expression.syntax.Parameter.VARYING_TEXTS
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
 * The functions of the language.
 *
 * @property title its name; functions with the same name differ in their number of operands.
 * @property movesTimes whether it may return more samples than it receives.
 * @property needsSteps whether its result changes while its first operand holds.
 * @property needsLasting whether it is meaningless for moments.
 * @property timing whether its result exists only at moments.
 * @property unit the unit of its result.
 */
internal enum class Function(
    val title: String,
    val parameters: List<Parameter>,
    val result: Result,
    val movesTimes: Boolean = false,
    val needsSteps: Boolean = false,
    val needsLasting: Boolean = needsSteps,
    val timing: Timing = Timing.AS_OPERANDS,
    val unit: UnitOfResult = UnitOfResult.UNKNOWN,
    val compute: (Arguments) -> Value,
) {
    MIN("min", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).minimum() }),
    MAX("max", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).maximum() }),
    MEAN("mean", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).mean(it.range) }),
    MEDIAN("median", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).percentile(50.0, it.range)
    }),
    PERCENTILE(
        "percentile",
        listOf(VARYING_NUMBERS, SHARE),
        Result.NUMBER,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).percentile(it.number(1), it.range) },
    ),
    STDDEV("stddev", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).standardDeviation(it.range)
    }),
    SAMPLE_MEAN("sample_mean", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).sampleMean()
    }),
    SAMPLE_MEDIAN("sample_median", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).samplePercentile(50.0)
    }),
    SAMPLE_PERCENTILE(
        "sample_percentile",
        listOf(VARYING_NUMBERS, SHARE),
        Result.NUMBER,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).samplePercentile(it.number(1)) },
    ),
    SAMPLE_STDDEV("sample_stddev", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).sampleStandardDeviation()
    }),
    FIRST("first", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).first() }),
    LAST("last", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).last(it.range) }),
    INTEGRAL("integral", listOf(VARYING_NUMBERS), Result.NUMBER, needsLasting = true, compute = { it.column(0).wholeIntegral(it.range) }),
    DURATION("duration", listOf(VARYING), Result.NUMBER, unit = UnitOfResult.AXIS, compute = { it.column(0).duration(it.range) }),
    COUNT("count", listOf(VARYING), Result.NUMBER, unit = UnitOfResult.NONE, compute = { it.column(0).count(it.isCondition(0), it.range) }),
    TIME_OF_MIN("time_of_min", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AXIS, compute = {
        it.column(0).minimum().timeAlone()
    }),
    TIME_OF_MAX("time_of_max", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AXIS, compute = {
        it.column(0).maximum().timeAlone()
    }),
    ANY("any", listOf(VARYING_CONDITION), Result.CONDITION, compute = { it.column(0).any(it.range) }),
    ALL("all", listOf(VARYING_CONDITION), Result.CONDITION, compute = { it.column(0).all() }),
    SLOPE("slope", listOf(VARYING_NUMBERS, VARYING_NUMBERS), Result.NUMBER, compute = { it.regression().slope }),
    CORRELATION(
        "correlation",
        listOf(VARYING_NUMBERS, VARYING_NUMBERS),
        Result.NUMBER,
        unit = UnitOfResult.NONE,
        compute = { it.regression().correlation },
    ),
    TOTAL("total", listOf(VARYING_CONDITION), Result.NUMBER, needsLasting = true, unit = UnitOfResult.AXIS, compute = {
        it.column(0).total(it.range)
    }),

    WINDOW_MIN(
        "min",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        needsSteps = true,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).windowExtreme(it.number(1), isLargest = false) },
    ),
    WINDOW_MAX(
        "max",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        needsSteps = true,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).windowExtreme(it.number(1), isLargest = true) },
    ),
    WINDOW_MEAN(
        "mean",
        listOf(VARYING_NUMBERS, WINDOW),
        Result.NUMBERS,
        needsSteps = true,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).windowMean(it.number(1)) },
    ),
    DELTA("delta", listOf(VARYING_NUMBERS), Result.NUMBERS, timing = Timing.AT_MOMENTS, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).delta()
    }),
    DERIVATIVE("derivative", listOf(VARYING_NUMBERS), Result.NUMBERS, compute = { it.column(0).derivative() }),
    AREA("area", listOf(VARYING_NUMBERS), Result.NUMBERS, needsSteps = true, compute = { it.column(0).area() }),
    PREVIOUS("previous", listOf(VARYING), Result.AS_FIRST, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).previous() }),
    HOLD("hold", listOf(VARYING), Result.AS_FIRST, timing = Timing.LASTING, unit = UnitOfResult.AS_FIRST, compute = {
        it.column(0).hold()
    }),
    SHIFT_TIME(
        "shift",
        listOf(VARYING, SHIFT),
        Result.AS_FIRST,
        movesTimes = true,
        unit = UnitOfResult.AS_FIRST,
        compute = { it.column(0).shifted(it.number(1)) },
    ),
    CHANGED("changed", listOf(VARYING), Result.CONDITIONS, timing = Timing.AT_MOMENTS, compute = { it.column(0).changed() }),
    RISES("rises", listOf(VARYING_CONDITION), Result.CONDITIONS, timing = Timing.AT_MOMENTS, compute = { it.column(0).rises(it.range) }),
    FALLS("falls", listOf(VARYING_CONDITION), Result.CONDITIONS, timing = Timing.AT_MOMENTS, compute = { it.column(0).falls(it.range) }),
    CROSSES(
        "crosses",
        listOf(VARYING_NUMBERS, NUMBERS),
        Result.CONDITIONS,
        timing = Timing.AT_MOMENTS,
        compute = { it.crossings() },
    ),
    LENGTHS(
        "lengths",
        listOf(VARYING_CONDITION),
        Result.NUMBERS,
        needsLasting = true,
        timing = Timing.AT_MOMENTS,
        unit = UnitOfResult.AXIS,
        compute = { it.column(0).lengths(it.range) },
    ),
    CYCLE_TIMES(
        "cycle_times",
        listOf(VARYING_CONDITION),
        Result.NUMBERS,
        timing = Timing.AT_MOMENTS,
        unit = UnitOfResult.AXIS,
        compute = { it.column(0).cycleTimes(it.range) },
    ),
    AFTER(
        "after",
        listOf(VARYING_CONDITION, WINDOW),
        Result.CONDITIONS,
        movesTimes = true,
        timing = Timing.LASTING,
        compute = { it.column(0).after(it.number(1), it.range) },
    ),
    BEFORE(
        "before",
        listOf(VARYING_CONDITION, WINDOW),
        Result.CONDITIONS,
        movesTimes = true,
        timing = Timing.LASTING,
        compute = { it.column(0).before(it.number(1), it.range) },
    ),
    FIRST_PART(
        "first",
        listOf(VARYING_CONDITION, WINDOW),
        Result.CONDITIONS,
        needsLasting = true,
        movesTimes = true,
        compute = { it.column(0).firstPart(it.number(1), it.range) },
    ),
    LAST_PART(
        "last",
        listOf(VARYING_CONDITION, WINDOW),
        Result.CONDITIONS,
        needsLasting = true,
        movesTimes = true,
        compute = { it.column(0).lastPart(it.number(1), it.range) },
    ),
    TEXT_NUMBER("number", listOf(VARYING_TEXTS), Result.NUMBERS, compute = { numbers(it.column(0), "") }),
    TEXT_NUMBER_AFTER("number", listOf(VARYING_TEXTS, TEXT), Result.NUMBERS, compute = { numbers(it.column(0), it.text(1)) }),
    MISSING("missing", listOf(VARYING), Result.CONDITIONS, compute = { it.column(0).missing() }),
    DURING(
        "during",
        listOf(ONE_NUMBER, ONE_NUMBER),
        Result.CONDITIONS,
        movesTimes = true,
        compute = { during(it.number(0), it.number(1), it.range) },
    ),

    IF("if", listOf(CONDITION, NUMBERS_OR_CONDITION, NUMBERS_OR_CONDITION), Result.AS_CHOSEN, compute = { it.chosen() }),
    CLAMP("clamp", listOf(NUMBERS, NUMBERS, NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.AS_FIRST, compute = { it.clamped() }),
    ATAN2("atan2", listOf(NUMBERS, NUMBERS), Result.ELEMENTWISE, compute = { it.elementwise { y, x -> atan2(y, x) } }),
    ABS("abs", listOf(NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.AS_FIRST, compute = { it.elementwise { x, _ -> abs(x) } }),
    SIGN("sign", listOf(NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.NONE, compute = { it.elementwise { x, _ -> sign(x) } }),
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
    FLOOR("floor", listOf(NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.AS_FIRST, compute = { it.elementwise { x, _ -> floor(x) } }),
    CEIL("ceil", listOf(NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.AS_FIRST, compute = { it.elementwise { x, _ -> ceil(x) } }),
    ROUND("round", listOf(NUMBERS), Result.ELEMENTWISE, unit = UnitOfResult.AS_FIRST, compute = { it.elementwise { x, _ -> round(x) } }),
    ;

    /** Whether the result of a function over time exists only at moments. */
    enum class Timing { AS_OPERANDS, AT_MOMENTS, LASTING }

    /** The unit of a function's result: the first operand's, the unit of x, none, or a special one. */
    enum class UnitOfResult { AS_FIRST, AXIS, NONE, UNKNOWN }

    /** The kind of a function's result. */
    enum class Result {
        NUMBER,
        CONDITION,
        NUMBERS,
        CONDITIONS,

        /** The kind of its first operand. */
        AS_FIRST,

        /** The kind of its second and third operands; over time if one of the operands is. */
        AS_CHOSEN,

        /** A number; over time if one of its operands is. */
        ELEMENTWISE,
    }

    companion object {
        private val byTitle = entries.groupBy { it.title }

        /** Returns the functions called [name], regardless of case; empty if there are none. */
        fun called(name: String): List<Function> = byTitle[name.lowercase()].orEmpty()
    }
}
