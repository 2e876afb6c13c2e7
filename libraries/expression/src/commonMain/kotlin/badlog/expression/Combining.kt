package badlog.expression

/** Calculates with each two samples of [left] and [right] at their common times; for [absent] see [Joined]. */
internal fun combined(left: Value, right: Value, operation: Operation, absent: Double = Double.NaN): Value {
    if (left is Scalar && right is Scalar) return Scalar(operation.of(left.value, right.value), timeOf(left, right))
    val joined = Joined(listOf(left, right), absent)
    val (one, other) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation.of(one[it], other[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** Where one of the two is a constant, the result is found where the other was. */
private fun timeOf(left: Scalar, right: Scalar) = when {
    left.time.isNaN() -> right.time
    right.time.isNaN() -> left.time
    else -> Double.NaN
}

/** The samples of [value] where [condition] holds, gaps elsewhere. */
internal fun restricted(value: Value, condition: Value): Value {
    val result = combined(value, condition, Operator.WHEN.operation)
    val texts = (value as? Column)?.texts
    return if (texts == null || result !is Column) result else Column(result.x, result.y, texts, result.isMomentary, result.stretches)
}

/** [whenTrue] where [condition] holds, [whenFalse] where it does not, a gap where that is not known. */
internal fun chosen(condition: Value, whenTrue: Value, whenFalse: Value): Value =
    combinedThree(condition, whenTrue, whenFalse) { on, yes, no ->
        if (on == 1.0) {
            yes
        } else if (on == 0.0) {
            no
        } else {
            Double.NaN
        }
    }

/** [value], but not below [low] nor above [high]; where those cross, [high]. */
internal fun clamped(value: Value, low: Value, high: Value): Value =
    combinedThree(value, low, high) { sample, least, most -> minOf(maxOf(sample, least), most) }

private inline fun combinedThree(a: Value, b: Value, c: Value, operation: (Double, Double, Double) -> Double): Value {
    if (a is Scalar && b is Scalar && c is Scalar) return Scalar(operation(a.value, b.value, c.value))
    // Between events none of them holds.
    val joined = Joined(listOf(a, b, c), absent = 0.0)
    val (first, second, third) = joined.operands
    val x = joined.x!!
    val samples = DoubleArray(x.size) { operation(first[it], second[it], third[it]) }
    return Column(x, samples, null, joined.isMomentary, joined.stretches)
}

/** True where [condition] is false. */
internal fun inverted(condition: Value): Value = combined(Scalar(1.0), condition, Operator.MINUS.operation)
