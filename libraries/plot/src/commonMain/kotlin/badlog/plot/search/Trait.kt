package badlog.plot.search

/**
 * What a search can ask of a topic beside its name.
 *
 * @property word how a person asks for it.
 */
public enum class Trait(public val word: String) {
    /** Its values are states, or true and false. */
    STATE("is:state"),

    /** Its values are numbers. */
    NUMBER("is:number"),

    /** Its values are texts that say what happened. */
    EVENT("is:event"),

    /** It never changes. */
    CONSTANT("is:constant"),

    /** Nothing was logged of it. */
    EMPTY("is:empty"),

    /** A finding is about it. */
    FINDING("has:finding"),
    ;

    public companion object {
        private val BY_WORD = entries.associateBy { it.word }

        /** What [word], in lower case, asks for; null for a word like others. */
        public fun of(word: String): Trait? = BY_WORD[word]
    }
}
