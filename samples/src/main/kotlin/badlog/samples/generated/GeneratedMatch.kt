package badlog.samples.generated

import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming

/**
 * The log of a simulated match with a known fault, or without one.
 *
 * @property name a name for its file, without an ending.
 * @property seed the seed of all random numbers in it; the match without the fault has the same.
 * @property naming the logger, which decides the topics and their names.
 * @property fault the fault; null for none.
 * @property strength the strength of the fault, from 1 (clear) down to 0.3 (faint); 0 without a fault.
 * @property hardship the circumstance that makes the match hard to judge, in words.
 * @property isHard whether it has a hardship that a program might mistake for a fault.
 * @property start the start of the fault on the log's x axis, in s; null without a fault.
 * @property part the faulty part of the robot, such as `Elevator`; empty if it is the whole robot, or none.
 * @property evidence the names of topics that show the fault. Elements of arrays and fields of structs have names that begin with these.
 * @property bytes the file, a bag or a WPILOG.
 */
class GeneratedMatch internal constructor(
    val name: String,
    val seed: Long,
    val naming: Naming,
    val fault: Fault?,
    val strength: Double,
    val hardship: String,
    val isHard: Boolean,
    val start: Double?,
    val part: String,
    val evidence: List<String>,
    val bytes: ByteArray,
) {
    /** The name of its file. */
    val fileName: String get() = name + if (naming.isBag) ".bag" else ".wpilog"
}
