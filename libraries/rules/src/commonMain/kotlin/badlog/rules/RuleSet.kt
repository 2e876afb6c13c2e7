package badlog.rules

/**
 * Rules to run over logs, and the aliases they use. `docs/rules.md` has the format of the file that they are read from.
 *
 * @property rules in the order of the file; no two have the same name.
 */
public class RuleSet internal constructor(internal val aliases: List<Alias>, public val rules: List<Rule>) {
    public companion object {
        /** No rules. */
        public val NONE: RuleSet = RuleSet(emptyList(), emptyList())
    }
}
