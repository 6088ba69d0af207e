"""Clouds over a place at any hour, and what they make of each of its lights.

- layer_in_air    An even layer of cloud between the air above and the air below
- remembered      A lit field of cloud that remembers what was seen of it: several lights share its rays
- diffuse_light   Light without a beam, such as airglow, on a field of cloud, and the air before it
- overcast        Each light of an hour under such a layer
- behind_field    Each light of an hour with a field of cloud before it
- over_place      What stands over the place: nothing, an overcast, a field
"""
