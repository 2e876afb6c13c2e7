package badlog.samples.generated.fault

/** The parts that a robot can have; faults need some of them. */
enum class Need { TANK, SWERVE, ELEVATOR, ARM, SHOOTER, INTAKE, PNEUMATICS, VISION }

/**
 * A kind of fault, with the causes that a mentor would accept and the logs that show it. Faults were written from public facts, before the
 * programs that they test.
 *
 * @property id its name, such as `loose-battery-lead`.
 * @property cause the sentence that a mentor would accept as the cause.
 * @property causes phrases; every acceptable statement of the cause contains at least one of them.
 * @property symptoms phrases for symptoms: true of such a match, but not the cause.
 * @property strength the physical meaning of strengths from 1 (clear) down to 0.3 (faint).
 * @property start the range of its possible starts, in s after the start of autonomous; 0 to 0 if the robot has it before the match.
 * @property needs the parts that the robot must have.
 * @property shownBy the signals that change because of it; signals of parts belong to the faulty part.
 * @property unseen the namings with logs that do not show the cause, and why.
 */
class Fault(
    val id: String,
    val cause: String,
    val causes: List<Phrase>,
    val symptoms: List<Phrase>,
    val strength: String,
    val start: ClosedFloatingPointRange<Double>,
    val needs: Set<Need>,
    val shownBy: Set<Signal>,
    val unseen: Map<Naming, Sight>,
) {
    /** Returns the visibility of the fault in a log of [naming]. */
    fun sightIn(naming: Naming): Sight = unseen[naming] ?: Sight(Visibility.CAUSE)

    /** Returns the verdict on [sentence] as a statement of the cause, if this is the fault. */
    fun verdictOn(sentence: String): Verdict = when {
        causes.any { it.isIn(sentence) } -> Verdict.CAUSE
        symptoms.any { it.isIn(sentence) } -> Verdict.SYMPTOM
        else -> Verdict.OTHER
    }

    override fun toString(): String = id
}

/** Collects the parts of a [Fault], for the tables. */
internal class FaultBuilder(private val id: String, private val cause: String) {
    private val causes = ArrayList<Phrase>()
    private val symptoms = ArrayList<Phrase>()
    private val needs = LinkedHashSet<Need>()
    private val shownBy = LinkedHashSet<Signal>()
    private val unseen = LinkedHashMap<Naming, Sight>()
    private var strength = ""
    private var start = 0.0..0.0

    fun causes(vararg phrases: String) {
        phrases.mapTo(causes, ::Phrase)
    }

    fun symptoms(vararg phrases: String) {
        phrases.mapTo(symptoms, ::Phrase)
    }

    fun strength(meaning: String) {
        strength = meaning
    }

    fun starts(from: Double, to: Double) {
        start = from..to
    }

    fun needs(vararg parts: Need) {
        needs += parts
    }

    fun shownBy(vararg signals: Signal) {
        shownBy += signals
    }

    /** Declares that logs of [namings] show only the symptom. */
    fun onlySymptom(vararg namings: Naming, because: String) {
        for (naming in namings) unseen[naming] = Sight(Visibility.SYMPTOM, because)
    }

    /** Declares that logs of [namings] show nothing of it. */
    fun notSeen(vararg namings: Naming, because: String) {
        for (naming in namings) unseen[naming] = Sight(Visibility.NOTHING, because)
    }

    fun build() = Fault(id, cause, causes, symptoms, strength, start, needs, shownBy, unseen)
}

internal fun fault(id: String, cause: String, parts: FaultBuilder.() -> Unit): Fault = FaultBuilder(id, cause).apply(parts).build()
