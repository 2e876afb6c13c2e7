package badlog.signals.battery

import kotlin.math.sqrt

/**
 * Returns the mean of [resistances], one per match, with its uncertainty (95 %); null if none has an uncertainty. Matches differ by more than their
 * own uncertainty, since batteries are warm or half empty. The excess is estimated from them, as DerSimonian and Laird do for trials in medicine
 * (Controlled Clinical Trials 7, 1986); if there is one, Student's t is used. A single match has its own uncertainty only.
 */
fun meanOf(resistances: List<Resistance>): Resistance? {
    val known = resistances.filter { it.uncertainty > 0 }
    if (known.isEmpty()) return null
    val variances = known.map { (it.uncertainty / NORMAL95).let { error -> error * error } }
    val between = varianceBetween(known.map { it.milliohms }, variances.map { 1 / it })
    val weights = variances.map { 1 / (it + between) }
    val mean = known.indices.sumOf { weights[it] * known[it].milliohms } / weights.sum()
    val errors = if (between > 0) quantile95(known.size - 1) else NORMAL95
    return Resistance(mean, errors * sqrt(1 / weights.sum()))
}

private fun varianceBetween(values: List<Double>, weights: List<Double>): Double {
    val total = weights.sum()
    val mean = values.indices.sumOf { weights[it] * values[it] } / total
    val scatter = values.indices.sumOf { weights[it] * (values[it] - mean) * (values[it] - mean) }
    val whole = total - weights.sumOf { it * it } / total
    return if (values.size < 2) 0.0 else maxOf(0.0, (scatter - (values.size - 1)) / whole)
}
