"""Clouds over a place at any hour, and what they make of each of its lights.

- overcast        An even layer of cloud: what it lets through, spread as overcast skies are
- remembered      A lit field of cloud that remembers what was seen of it: several lights share its rays
- diffuse_light   Light without a beam, such as airglow, on a field of cloud, and the air before it
- behind_field    Each light of an hour with a field of cloud before it
- over_place      What stands over the place: nothing, an overcast, a field
"""
