package badlog.rules.confusion

import kotlin.random.Random

/**
 * Returns the share of [groups]' members that meet [isCounted], in percent, with an interval of 95 %. The interval has 95 % of the shares that other
 * choices of groups would give. Groups are resampled, not members: matches with the same fault show much the same.
 */
internal fun <T> shareText(groups: List<List<T>>, isCounted: (T) -> Boolean): String {
    val counts = groups.filter { it.isNotEmpty() }.map { group -> group.count(isCounted) to group.size }
    if (counts.isEmpty()) return "–"
    val random = Random(SEED)
    val shares = List(RESAMPLES) { shareOf(List(counts.size) { counts.random(random) }) }.sorted()
    return "%.1f %% (%.1f to %.1f)".format(shareOf(counts), shares[RESAMPLES * 25 / 1000], shares[RESAMPLES * 975 / 1000 - 1])
}

private fun shareOf(counts: List<Pair<Int, Int>>) = 100.0 * counts.sumOf { it.first } / counts.sumOf { it.second }

private const val RESAMPLES = 2000
private const val SEED = 1
