package badlog.report.rules

/**
 * Rules to run over logs, and the aliases they use. `docs/rules.md` has the format of the file.
 *
 * @property rules in the order of the file.
 * @property source the file it was read from.
 */
public class RuleSet internal constructor(
    internal val aliases: List<Alias>,
    public val rules: List<Rule>,
    public val source: String,
) {
    public companion object {
        /**
         * Reads a file of rules, in TOML.
         *
         * The expressions are checked when they meet a log, because what is a name depends on it.
         *
         * @throws RulesException when it is not one.
         */
        public fun parse(text: String): RuleSet = RulesReader(text).read()

        /** The rules that badlog brings along. */
        public val DEFAULT: RuleSet by lazy {
            val stream = checkNotNull(RuleSet::class.java.getResourceAsStream("/badlog/report/badlog-rules.toml"))
            parse(stream.use { it.readBytes().decodeToString() })
        }
    }
}
