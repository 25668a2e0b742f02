"""Forces: what loads, weights and inertia ask of the joints and of the driver."""
