package badlog.samples.generated

import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming

/**
 * The log of a simulated match, and what is wrong in it.
 *
 * @property name a name for its file, without an ending.
 * @property seed what everything random in it followed from; the match without the fault has the same.
 * @property naming how its topics are named, and which there are.
 * @property fault what is wrong; null for nothing.
 * @property strength how strong the fault is, from 1 (clear) down to 0.3 (faint); 0 without a fault.
 * @property hardship what makes the match hard, in words.
 * @property isHard whether it has a hardship that a program might take for a fault.
 * @property start when the fault starts, on the log's x axis in s; null without a fault.
 * @property part the part of the robot that is faulty, as in `Elevator`; empty if it is the whole robot, or nothing.
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
