package badlog.viewer.shown.search

/**
 * What a search can ask for about a topic besides its name.
 *
 * @property word how a person writes it.
 */
enum class Trait(val word: String) {
    /** Its values are states, or true and false. */
    STATE("is:state"),

    /** Its values are numbers. */
    NUMBER("is:number"),

    /** Its values are texts that say what happened. */
    EVENT("is:event"),

    /** It never changes. */
    CONSTANT("is:constant"),

    /** It has no logged values. */
    EMPTY("is:empty"),

    /** A finding is about it. */
    FINDING("has:finding"),
    ;

    companion object {
        private val BY_WORD = entries.associateBy { it.word }

        /** Returns the trait that [word], in lower case, asks for; null for an ordinary word. */
        fun of(word: String): Trait? = BY_WORD[word]
    }
}
