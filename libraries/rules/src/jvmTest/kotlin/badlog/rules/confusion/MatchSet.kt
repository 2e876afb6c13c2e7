package badlog.rules.confusion

import badlog.samples.generated.GeneratedMatch
import badlog.samples.generated.MatchGenerator
import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.STRENGTHS

/**
 * Matches for one purpose.
 *
 * @property seed the seed of the matches; null if it has to be given: for the final set, the hash of the commit that was frozen for it.
 * @property namings how their robots name topics. Rules are never fitted to the others.
 */
internal enum class MatchSet(val seed: Long?, val namings: List<Naming>) {
    TUNING(1, listOf(Naming.ADVANTAGEKIT, Naming.WPILIB, Naming.BADLOG)),
    TRIAL(2, Naming.entries),
    FINAL(null, Naming.entries),
}

/** Returns a function for each match of [set] with a fault: each fault in each strength and naming, [rounds] times. */
internal fun faultyMatches(set: MatchSet, seed: Long, rounds: Int): List<() -> GeneratedMatch> {
    val generator = MatchGenerator(seed)
    return set.namings.flatMap { naming ->
        FAULTS.flatMap { fault: Fault ->
            STRENGTHS.flatMap { strength -> (0 until rounds).map { round -> { generator.faulty(naming, fault, strength, round) } } }
        }
    }
}

/** Returns functions for [count] matches without a fault for each naming of [set]; a third of them are hard. */
internal fun healthyMatches(set: MatchSet, seed: Long, count: Int): List<() -> GeneratedMatch> {
    val generator = MatchGenerator(seed)
    return set.namings.flatMap { naming -> (0 until count).map { number -> { generator.healthy(naming, number) } } }
}
