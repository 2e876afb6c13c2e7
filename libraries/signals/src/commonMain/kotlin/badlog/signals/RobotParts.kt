package badlog.signals

import badlog.expression.signals.Signal
import badlog.signals.derived.BusDevice
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.derived.busDeviceIn
import badlog.signals.derived.busDevicesOf
import badlog.signals.derived.partTopicsOf
import badlog.signals.swerve.ModuleTopics
import badlog.signals.swerve.moduleTopicsOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.unitScale

/** The parts of a robot, found by the names of its log's topics [names]. */
internal class RobotParts(names: List<Signal>, vocabulary: SignalVocabulary) {
    /** All topics that name a part. */
    val topics: List<PartTopic> = partTopicsOf(names.filter { busDeviceIn(it.name) == null }, vocabulary)

    /** The topics of mechanisms, not of the drive. */
    val mechanisms: List<PartTopic> = topics.filter { part -> part.part.none { it in DRIVE_WORDS } }
    val byPart: Map<List<String>, List<PartTopic>> = mechanisms.groupBy { it.part }
    val modules: List<ModuleTopics> = moduleTopicsOf(names, topics)

    /** The topics of single sides of a tank drive, without targets. */
    val sides: List<PartTopic> = topics.filter { topic ->
        topic.part.any { it in DRIVE_WORDS } && topic.part.count { it in CORNERS } == 1 && !topic.isTarget
    }

    /** The devices that are known by their ids alone. */
    val devices: List<BusDevice> = busDevicesOf(names)

    /** Returns the measured topic that follows [target]; null if there is none. */
    fun measuredOf(target: PartTopic): PartTopic? = byPart[target.part].orEmpty()
        .filter { !it.isTarget && (it.quantity == Quantity.POSITION || it.quantity == Quantity.VELOCITY) && scaleOf(it, target) != null }
        .filter { target.quantity == Quantity.NONE || it.quantity == target.quantity }
        .maxByOrNull { (if (it.unit == target.unit) 4 else 0) + (if (it.isAbsolute) 2 else 0) + (if (it.isMotor) 0 else 1) }

    private companion object {
        val DRIVE_WORDS = setOf("drive", "drivetrain", "drivebase", "module", "swerve", "chassis", "drive0")
        val CORNERS = setOf("front", "back", "rear", "left", "right")
    }
}

/** Returns the factor from the unit of [from] to the unit of [to], 1 if one has none. Null if they do not measure the same. */
internal fun scaleOf(from: PartTopic, to: PartTopic): Double? =
    if (from.unit.isEmpty() || to.unit.isEmpty()) 1.0 else unitScale(from.unit, to.unit)
