package badlog.analysis

/**
 * The attributes that mean something.
 *
 * @property attributes them; of two with one name the later counts.
 */
public class AttributeRegistry(public val attributes: List<Attribute>) {
    private val byName = attributes.associateBy { it.name }

    /** This registry and one attribute more. */
    public operator fun plus(attribute: Attribute): AttributeRegistry = AttributeRegistry(attributes + attribute)

    internal fun find(text: String): Attribute? = byName[text.substringBefore(':')]

    public companion object {
        /** The attributes of `docs/bag-format.md`. */
        public val STANDARD: AttributeRegistry = AttributeRegistry(STANDARD_ATTRIBUTES)
    }
}
