package badlog.samples.generated.fault

/** What a robot needs for a fault to be possible. */
enum class Need { TANK, SWERVE, ELEVATOR, ARM, SHOOTER, INTAKE, PNEUMATICS, VISION }

/**
 * A kind of fault: what happens, what a mentor would accept as its cause, and which logs show it. Written from public facts, and
 * before the programs that it tests.
 *
 * @property id its name, as in `loose-battery-lead`.
 * @property cause the sentence that a mentor would accept as the cause.
 * @property causes phrases of which at least one is in every acceptable statement of the cause.
 * @property symptoms phrases for what is also true of such a match, but is not the cause.
 * @property strength what a strength from 1 (clear) down to 0.3 (faint) means physically.
 * @property start when it starts, in s after the start of autonomous: a moment in this range; 0 to 0 for a fault that the robot
 *   brings to the match.
 * @property needs what the robot must have.
 * @property shownBy the signals that change because of it, of the part that is faulty if they belong to a part.
 * @property unseen the namings whose logs do not show the cause, and why.
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
    /** Returns what a log of [naming] shows of it. */
    fun sightIn(naming: Naming): Sight = unseen[naming] ?: Sight(Visibility.CAUSE)

    /** Returns how near [sentence] is to the truth, if this is the fault. */
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
